(cl:defpackage rotors_comm-srv
  (:use )
  (:export
   "RECORDROSBAG"
   "<RECORDROSBAG-REQUEST>"
   "RECORDROSBAG-REQUEST"
   "<RECORDROSBAG-RESPONSE>"
   "RECORDROSBAG-RESPONSE"
  ))

