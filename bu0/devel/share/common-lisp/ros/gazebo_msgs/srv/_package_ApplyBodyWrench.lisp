(cl:in-package gazebo_msgs-srv)
(cl:export '(BODY_NAME-VAL
          BODY_NAME
          REFERENCE_FRAME-VAL
          REFERENCE_FRAME
          REFERENCE_POINT-VAL
          REFERENCE_POINT
          WRENCH-VAL
          WRENCH
          START_TIME-VAL
          START_TIME
          DURATION-VAL
          DURATION
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))