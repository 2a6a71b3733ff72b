set(rotors_comm_MESSAGE_FILES "msg/WindSpeed.msg")
set(rotors_comm_SERVICE_FILES "srv/RecordRosbag.srv")
