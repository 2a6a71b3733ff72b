(cl:in-package gazebo_msgs-msg)
(cl:export '(LINK_NAME-VAL
          LINK_NAME
          POSE-VAL
          POSE
          TWIST-VAL
          TWIST
          REFERENCE_FRAME-VAL
          REFERENCE_FRAME
))