(cl:in-package mav_msgs-msg)
(cl:export '(HEADER-VAL
          HEADER
          ATTITUDE-VAL
          ATTITUDE
          THRUST-VAL
          THRUST
))