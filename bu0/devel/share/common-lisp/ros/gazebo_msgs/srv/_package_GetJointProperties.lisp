(cl:in-package gazebo_msgs-srv)
(cl:export '(JOINT_NAME-VAL
          JOINT_NAME
          TYPE-VAL
          TYPE
          DAMPING-VAL
          DAMPING
          POSITION-VAL
          POSITION
          RATE-VAL
          RATE
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))