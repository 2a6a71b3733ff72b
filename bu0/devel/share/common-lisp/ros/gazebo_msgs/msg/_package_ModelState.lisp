(cl:in-package gazebo_msgs-msg)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          POSE-VAL
          POSE
          TWIST-VAL
          TWIST
          REFERENCE_FRAME-VAL
          REFERENCE_FRAME
))