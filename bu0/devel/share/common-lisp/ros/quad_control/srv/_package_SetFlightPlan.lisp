(cl:in-package quad_control-srv)
(cl:export '(X-VAL
          X
          Y-VAL
          Y
          Z-VAL
          Z
          YAW-VAL
          YAW
          FEED_FORWARD_MASS-VAL
          FEED_FORWARD_MASS
          INITIAL_ALTITUDE_EFFORT-VAL
          INITIAL_ALTITUDE_EFFORT
          EXPLORATION_START-VAL
          EXPLORATION_START
          EXPLORATION_SIGNAL-VAL
          EXPLORATION_SIGNAL
          SUCCESS-VAL
          SUCCESS
          MESSAGE-VAL
          MESSAGE
))