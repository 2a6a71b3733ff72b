(cl:in-package quad_control-srv)
(cl:export '(SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
          TIME-VAL
          TIME
          THRUST-VAL
          THRUST
          TAU_PHI-VAL
          TAU_PHI
          TAU_THETA-VAL
          TAU_THETA
          TAU_PSI-VAL
          TAU_PSI
          T_EFF-VAL
          T_EFF
          CLAMPED-VAL
          CLAMPED
))