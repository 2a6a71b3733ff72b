(cl:in-package gazebo_msgs-srv)
(cl:export '(LINK_NAME-VAL
          LINK_NAME
          COM-VAL
          COM
          GRAVITY_MODE-VAL
          GRAVITY_MODE
          MASS-VAL
          MASS
          IXX-VAL
          IXX
          IXY-VAL
          IXY
          IXZ-VAL
          IXZ
          IYY-VAL
          IYY
          IYZ-VAL
          IYZ
          IZZ-VAL
          IZZ
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))