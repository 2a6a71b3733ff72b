; Auto-generated. Do not edit!


(cl:in-package quad_sim-srv)


;//! \htmlinclude SaveState-request.msg.html

(cl:defclass <SaveState-request> (roslisp-msg-protocol:ros-message)
  ()
)

(cl:defclass SaveState-request (<SaveState-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <SaveState-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'SaveState-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<SaveState-request> is deprecated: use quad_sim-srv:SaveState-request instead.")))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <SaveState-request>) ostream)
  "Serializes a message object of type '<SaveState-request>"
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <SaveState-request>) istream)
  "Deserializes a message object of type '<SaveState-request>"
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<SaveState-request>)))
  "Returns string type for a service object of type '<SaveState-request>"
  "quad_sim/SaveStateRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SaveState-request)))
  "Returns string type for a service object of type 'SaveState-request"
  "quad_sim/SaveStateRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<SaveState-request>)))
  "Returns md5sum for a message object of type '<SaveState-request>"
  "e883716c8ff1d9b09f97a4888a1b25c3")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'SaveState-request)))
  "Returns md5sum for a message object of type 'SaveState-request"
  "e883716c8ff1d9b09f97a4888a1b25c3")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<SaveState-request>)))
  "Returns full string definition for message of type '<SaveState-request>"
  (cl:format cl:nil "# The complete state of the world between two steps: vehicles, rotors, wind, samples on their way, time.~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'SaveState-request)))
  "Returns full string definition for message of type 'SaveState-request"
  (cl:format cl:nil "# The complete state of the world between two steps: vehicles, rotors, wind, samples on their way, time.~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <SaveState-request>))
  (cl:+ 0
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <SaveState-request>))
  "Converts a ROS message object to a list"
  (cl:list 'SaveState-request
))
;//! \htmlinclude SaveState-response.msg.html

(cl:defclass <SaveState-response> (roslisp-msg-protocol:ros-message)
  ((success
    :reader success
    :initarg :success
    :type cl:boolean
    :initform cl:nil)
   (message
    :reader message
    :initarg :message
    :type cl:string
    :initform "")
   (state
    :reader state
    :initarg :state
    :type cl:string
    :initform ""))
)

(cl:defclass SaveState-response (<SaveState-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <SaveState-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'SaveState-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<SaveState-response> is deprecated: use quad_sim-srv:SaveState-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <SaveState-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:success-val is deprecated.  Use quad_sim-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <SaveState-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:message-val is deprecated.  Use quad_sim-srv:message instead.")
  (message m))

(cl:ensure-generic-function 'state-val :lambda-list '(m))
(cl:defmethod state-val ((m <SaveState-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:state-val is deprecated.  Use quad_sim-srv:state instead.")
  (state m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <SaveState-response>) ostream)
  "Serializes a message object of type '<SaveState-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'state))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'state))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <SaveState-response>) istream)
  "Deserializes a message object of type '<SaveState-response>"
    (cl:setf (cl:slot-value msg 'success) (cl:not (cl:zerop (cl:read-byte istream))))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'message) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'message) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'state) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'state) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<SaveState-response>)))
  "Returns string type for a service object of type '<SaveState-response>"
  "quad_sim/SaveStateResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SaveState-response)))
  "Returns string type for a service object of type 'SaveState-response"
  "quad_sim/SaveStateResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<SaveState-response>)))
  "Returns md5sum for a message object of type '<SaveState-response>"
  "e883716c8ff1d9b09f97a4888a1b25c3")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'SaveState-response)))
  "Returns md5sum for a message object of type 'SaveState-response"
  "e883716c8ff1d9b09f97a4888a1b25c3")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<SaveState-response>)))
  "Returns full string definition for message of type '<SaveState-response>"
  (cl:format cl:nil "bool success~%string message~%string state            # a few lines of text; keep it as it is~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'SaveState-response)))
  "Returns full string definition for message of type 'SaveState-response"
  (cl:format cl:nil "bool success~%string message~%string state            # a few lines of text; keep it as it is~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <SaveState-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
     4 (cl:length (cl:slot-value msg 'state))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <SaveState-response>))
  "Converts a ROS message object to a list"
  (cl:list 'SaveState-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
    (cl:cons ':state (state msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'SaveState)))
  'SaveState-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'SaveState)))
  'SaveState-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SaveState)))
  "Returns string type for a service object of type '<SaveState>"
  "quad_sim/SaveState")