(cl:in-package quad_sim-srv)
(cl:export '(STEPS-VAL
          STEPS
          HOLD_STEPS-VAL
          HOLD_STEPS
          COMMAND_STAMP-VAL
          COMMAND_STAMP
          WAIT_FOR-VAL
          WAIT_FOR
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
))