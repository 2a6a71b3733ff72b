(cl:in-package mav_msgs-msg)
(cl:export '(HEADER-VAL
          HEADER
          ANGULAR_RATES-VAL
          ANGULAR_RATES
          THRUST-VAL
          THRUST
))