
(cl:in-package :asdf)

(defsystem "gazebo_msgs-msg"
  :depends-on (:roslisp-msg-protocol :roslisp-utils :geometry_msgs-msg
               :std_msgs-msg
)
  :components ((:file "_package")
    (:file "LinkState" :depends-on ("_package_LinkState"))
    (:file "_package_LinkState" :depends-on ("_package"))
    (:file "LinkStates" :depends-on ("_package_LinkStates"))
    (:file "_package_LinkStates" :depends-on ("_package"))
    (:file "ModelState" :depends-on ("_package_ModelState"))
    (:file "_package_ModelState" :depends-on ("_package"))
    (:file "ModelStates" :depends-on ("_package_ModelStates"))
    (:file "_package_ModelStates" :depends-on ("_package"))
    (:file "ODEPhysics" :depends-on ("_package_ODEPhysics"))
    (:file "_package_ODEPhysics" :depends-on ("_package"))
    (:file "PerformanceMetrics" :depends-on ("_package_PerformanceMetrics"))
    (:file "_package_PerformanceMetrics" :depends-on ("_package"))
    (:file "SensorPerformanceMetric" :depends-on ("_package_SensorPerformanceMetric"))
    (:file "_package_SensorPerformanceMetric" :depends-on ("_package"))
  ))