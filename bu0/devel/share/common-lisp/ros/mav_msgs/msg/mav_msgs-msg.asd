
(cl:in-package :asdf)

(defsystem "mav_msgs-msg"
  :depends-on (:roslisp-msg-protocol :roslisp-utils :geometry_msgs-msg
               :std_msgs-msg
)
  :components ((:file "_package")
    (:file "Actuators" :depends-on ("_package_Actuators"))
    (:file "_package_Actuators" :depends-on ("_package"))
    (:file "AttitudeThrust" :depends-on ("_package_AttitudeThrust"))
    (:file "_package_AttitudeThrust" :depends-on ("_package"))
    (:file "RateThrust" :depends-on ("_package_RateThrust"))
    (:file "_package_RateThrust" :depends-on ("_package"))
  ))