(cl:in-package gazebo_msgs-msg)
(cl:export '(NAME-VAL
          NAME
          SIM_UPDATE_RATE-VAL
          SIM_UPDATE_RATE
          REAL_UPDATE_RATE-VAL
          REAL_UPDATE_RATE
          FPS-VAL
          FPS
))