(cl:in-package gazebo_msgs-msg)
(cl:export '(HEADER-VAL
          HEADER
          REAL_TIME_FACTOR-VAL
          REAL_TIME_FACTOR
          SENSORS-VAL
          SENSORS
))