(cl:in-package rotors_comm-msg)
(cl:export '(HEADER-VAL
          HEADER
          VELOCITY-VAL
          VELOCITY
))