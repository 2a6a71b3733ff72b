set(mav_msgs_MESSAGE_FILES "/work/wt/unity/src/mav_msgs/msg/Actuators.msg;/work/wt/unity/src/mav_msgs/msg/AttitudeThrust.msg;/work/wt/unity/src/mav_msgs/msg/RateThrust.msg")
set(mav_msgs_SERVICE_FILES "")
