(cl:in-package quad_control-srv)
(cl:export '(STEPS-VAL
          STEPS
          HOLD_STEPS-VAL
          HOLD_STEPS
          TIMEOUT-VAL
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
          SERVICE_DELAY-VAL
          SERVICE_DELAY
          WAIT-VAL
          WAIT
          ESTIMATED_SERVICE_DELAY-VAL
          ESTIMATED_SERVICE_DELAY
))