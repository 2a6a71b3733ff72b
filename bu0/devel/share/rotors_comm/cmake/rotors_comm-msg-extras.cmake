set(rotors_comm_MESSAGE_FILES "/work/wt/unity/src/rotors_comm/msg/WindSpeed.msg")
set(rotors_comm_SERVICE_FILES "/work/wt/unity/src/rotors_comm/srv/RecordRosbag.srv")
