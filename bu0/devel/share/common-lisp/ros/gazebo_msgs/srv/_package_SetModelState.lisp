(cl:in-package gazebo_msgs-srv)
(cl:export '(MODEL_STATE-VAL
          MODEL_STATE
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))