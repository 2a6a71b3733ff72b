(cl:in-package quad_control-srv)
(cl:export '(TIMEOUT-VAL
          TIMEOUT
          SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
          MODE-VAL
          MODE
          INTERVALS-VAL
          INTERVALS
          DESIRED-VAL
          DESIRED
          MEAN-VAL
          MEAN
          STD-VAL
          STD
          MAX_ABS_ERROR-VAL
          MAX_ABS_ERROR
          MEAN_SERVICE_DELAY-VAL
          MEAN_SERVICE_DELAY
          ESTIMATED_SERVICE_DELAY-VAL
          ESTIMATED_SERVICE_DELAY
))