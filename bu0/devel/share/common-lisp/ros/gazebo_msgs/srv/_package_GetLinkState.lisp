(cl:in-package gazebo_msgs-srv)
(cl:export '(LINK_NAME-VAL
          LINK_NAME
          REFERENCE_FRAME-VAL
          REFERENCE_FRAME
          LINK_STATE-VAL
          LINK_STATE
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))