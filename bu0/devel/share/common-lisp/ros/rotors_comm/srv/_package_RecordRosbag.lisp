(cl:in-package rotors_comm-srv)
(cl:export '(RECORD-VAL
          RECORD
          SUCCESS-VAL
          SUCCESS
))