(cl:defpackage rotors_comm-msg
  (:use )
  (:export
   "<WINDSPEED>"
   "WINDSPEED"
  ))

