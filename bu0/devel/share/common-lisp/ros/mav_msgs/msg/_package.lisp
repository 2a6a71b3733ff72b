(cl:defpackage mav_msgs-msg
  (:use )
  (:export
   "<ACTUATORS>"
   "ACTUATORS"
   "<ATTITUDETHRUST>"
   "ATTITUDETHRUST"
   "<RATETHRUST>"
   "RATETHRUST"
  ))

