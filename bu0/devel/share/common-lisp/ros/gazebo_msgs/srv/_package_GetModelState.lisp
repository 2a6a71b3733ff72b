(cl:in-package gazebo_msgs-srv)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          RELATIVE_ENTITY_NAME-VAL
          RELATIVE_ENTITY_NAME
          HEADER-VAL
          HEADER
          POSE-VAL
          POSE
          TWIST-VAL
          TWIST
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))