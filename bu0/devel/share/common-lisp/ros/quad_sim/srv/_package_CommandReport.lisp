(cl:in-package quad_sim-srv)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
          RECEIVED-VAL
          RECEIVED
          WRONG_LENGTH-VAL
          WRONG_LENGTH
          NOT_FINITE-VAL
          NOT_FINITE
          LATE-VAL
          LATE
          NEGATIVE-VAL
          NEGATIVE
          OVER_LIMIT-VAL
          OVER_LIMIT
          LAST_PROBLEM-VAL
          LAST_PROBLEM
))