(cl:in-package gazebo_msgs-srv)
(cl:export '(SIM_TIME-VAL
          SIM_TIME
          MODEL_NAMES-VAL
          MODEL_NAMES
          RENDERING_ENABLED-VAL
          RENDERING_ENABLED
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))