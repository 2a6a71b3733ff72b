(cl:in-package gazebo_msgs-srv)
(cl:export '(BODY_NAME-VAL
          BODY_NAME
))