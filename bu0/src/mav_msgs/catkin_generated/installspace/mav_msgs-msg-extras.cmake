set(mav_msgs_MESSAGE_FILES "msg/Actuators.msg;msg/AttitudeThrust.msg;msg/RateThrust.msg")
set(mav_msgs_SERVICE_FILES "")
