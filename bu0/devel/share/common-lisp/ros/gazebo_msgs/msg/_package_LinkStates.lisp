(cl:in-package gazebo_msgs-msg)
(cl:export '(NAME-VAL
          NAME
          POSE-VAL
          POSE
          TWIST-VAL
          TWIST
))