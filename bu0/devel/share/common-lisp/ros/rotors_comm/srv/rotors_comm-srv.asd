
(cl:in-package :asdf)

(defsystem "rotors_comm-srv"
  :depends-on (:roslisp-msg-protocol :roslisp-utils )
  :components ((:file "_package")
    (:file "RecordRosbag" :depends-on ("_package_RecordRosbag"))
    (:file "_package_RecordRosbag" :depends-on ("_package"))
  ))