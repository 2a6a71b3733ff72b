(cl:in-package quad_sim-srv)
(cl:export '(SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
          STATE-VAL
          STATE
))