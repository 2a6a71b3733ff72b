
(cl:in-package :asdf)

(defsystem "quad_control-srv"
  :depends-on (:roslisp-msg-protocol :roslisp-utils :mav_msgs-msg
               :nav_msgs-msg
)
  :components ((:file "_package")
    (:file "Advance" :depends-on ("_package_Advance"))
    (:file "_package_Advance" :depends-on ("_package"))
    (:file "Begin" :depends-on ("_package_Begin"))
    (:file "_package_Begin" :depends-on ("_package"))
    (:file "FlightRecord" :depends-on ("_package_FlightRecord"))
    (:file "_package_FlightRecord" :depends-on ("_package"))
    (:file "SetFlightPlan" :depends-on ("_package_SetFlightPlan"))
    (:file "_package_SetFlightPlan" :depends-on ("_package"))
    (:file "TimingReport" :depends-on ("_package_TimingReport"))
    (:file "_package_TimingReport" :depends-on ("_package"))
  ))