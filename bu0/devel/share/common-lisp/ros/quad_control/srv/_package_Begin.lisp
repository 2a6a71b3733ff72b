(cl:in-package quad_control-srv)
(cl:export '(TIMEOUT-VAL
          TIMEOUT
          SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
          STAMP-VAL
          STAMP
          ODOMETRY-VAL
          ODOMETRY
          MOTOR_SPEED-VAL
          MOTOR_SPEED
))