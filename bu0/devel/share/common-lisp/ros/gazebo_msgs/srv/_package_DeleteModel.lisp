(cl:in-package gazebo_msgs-srv)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))