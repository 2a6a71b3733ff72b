(cl:in-package mav_msgs-msg)
(cl:export '(HEADER-VAL
          HEADER
          ANGLES-VAL
          ANGLES
          ANGULAR_VELOCITIES-VAL
          ANGULAR_VELOCITIES
          NORMALIZED-VAL
          NORMALIZED
))