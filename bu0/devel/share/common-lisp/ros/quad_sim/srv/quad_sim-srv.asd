
(cl:in-package :asdf)

(defsystem "quad_sim-srv"
  :depends-on (:roslisp-msg-protocol :roslisp-utils :mav_msgs-msg
               :nav_msgs-msg
)
  :components ((:file "_package")
    (:file "CommandReport" :depends-on ("_package_CommandReport"))
    (:file "_package_CommandReport" :depends-on ("_package"))
    (:file "RestoreState" :depends-on ("_package_RestoreState"))
    (:file "_package_RestoreState" :depends-on ("_package"))
    (:file "SaveState" :depends-on ("_package_SaveState"))
    (:file "_package_SaveState" :depends-on ("_package"))
    (:file "Step" :depends-on ("_package_Step"))
    (:file "_package_Step" :depends-on ("_package"))
  ))