(cl:in-package gazebo_msgs-srv)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          MODEL_XML-VAL
          MODEL_XML
          ROBOT_NAMESPACE-VAL
          ROBOT_NAMESPACE
          INITIAL_POSE-VAL
          INITIAL_POSE
          REFERENCE_FRAME-VAL
          REFERENCE_FRAME
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))