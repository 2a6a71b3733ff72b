(cl:in-package gazebo_msgs-srv)
(cl:export '(LINK_STATE-VAL
          LINK_STATE
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))