(cl:in-package quad_sim-srv)
(cl:export '(STATE-VAL
          STATE
          SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
))