; Auto-generated. Do not edit!


(cl:in-package quad_sim-srv)


;//! \htmlinclude RestoreState-request.msg.html

(cl:defclass <RestoreState-request> (roslisp-msg-protocol:ros-message)
  ((state
    :reader state
    :initarg :state
    :type cl:string
    :initform ""))
)

(cl:defclass RestoreState-request (<RestoreState-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <RestoreState-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'RestoreState-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<RestoreState-request> is deprecated: use quad_sim-srv:RestoreState-request instead.")))

(cl:ensure-generic-function 'state-val :lambda-list '(m))
(cl:defmethod state-val ((m <RestoreState-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:state-val is deprecated.  Use quad_sim-srv:state instead.")
  (state m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <RestoreState-request>) ostream)
  "Serializes a message object of type '<RestoreState-request>"
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'state))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'state))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <RestoreState-request>) istream)
  "Deserializes a message object of type '<RestoreState-request>"
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
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<RestoreState-request>)))
  "Returns string type for a service object of type '<RestoreState-request>"
  "quad_sim/RestoreStateRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'RestoreState-request)))
  "Returns string type for a service object of type 'RestoreState-request"
  "quad_sim/RestoreStateRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<RestoreState-request>)))
  "Returns md5sum for a message object of type '<RestoreState-request>"
  "1707e9634f2e8a719812510902b57897")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'RestoreState-request)))
  "Returns md5sum for a message object of type 'RestoreState-request"
  "1707e9634f2e8a719812510902b57897")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<RestoreState-request>)))
  "Returns full string definition for message of type '<RestoreState-request>"
  (cl:format cl:nil "# Continues bit for bit where SaveState was called, in this simulator or in another one with the same vehicles and options.~%# Commands that arrived are forgotten; whether the physics runs stays as it is.~%string state~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'RestoreState-request)))
  "Returns full string definition for message of type 'RestoreState-request"
  (cl:format cl:nil "# Continues bit for bit where SaveState was called, in this simulator or in another one with the same vehicles and options.~%# Commands that arrived are forgotten; whether the physics runs stays as it is.~%string state~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <RestoreState-request>))
  (cl:+ 0
     4 (cl:length (cl:slot-value msg 'state))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <RestoreState-request>))
  "Converts a ROS message object to a list"
  (cl:list 'RestoreState-request
    (cl:cons ':state (state msg))
))
;//! \htmlinclude RestoreState-response.msg.html

(cl:defclass <RestoreState-response> (roslisp-msg-protocol:ros-message)
  ((success
    :reader success
    :initarg :success
    :type cl:boolean
    :initform cl:nil)
   (message
    :reader message
    :initarg :message
    :type cl:string
    :initform ""))
)

(cl:defclass RestoreState-response (<RestoreState-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <RestoreState-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'RestoreState-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<RestoreState-response> is deprecated: use quad_sim-srv:RestoreState-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <RestoreState-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:success-val is deprecated.  Use quad_sim-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <RestoreState-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:message-val is deprecated.  Use quad_sim-srv:message instead.")
  (message m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <RestoreState-response>) ostream)
  "Serializes a message object of type '<RestoreState-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <RestoreState-response>) istream)
  "Deserializes a message object of type '<RestoreState-response>"
    (cl:setf (cl:slot-value msg 'success) (cl:not (cl:zerop (cl:read-byte istream))))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'message) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'message) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<RestoreState-response>)))
  "Returns string type for a service object of type '<RestoreState-response>"
  "quad_sim/RestoreStateResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'RestoreState-response)))
  "Returns string type for a service object of type 'RestoreState-response"
  "quad_sim/RestoreStateResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<RestoreState-response>)))
  "Returns md5sum for a message object of type '<RestoreState-response>"
  "1707e9634f2e8a719812510902b57897")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'RestoreState-response)))
  "Returns md5sum for a message object of type 'RestoreState-response"
  "1707e9634f2e8a719812510902b57897")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<RestoreState-response>)))
  "Returns full string definition for message of type '<RestoreState-response>"
  (cl:format cl:nil "bool success~%string message          # what does not fit; then nothing has changed~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'RestoreState-response)))
  "Returns full string definition for message of type 'RestoreState-response"
  (cl:format cl:nil "bool success~%string message          # what does not fit; then nothing has changed~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <RestoreState-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <RestoreState-response>))
  "Converts a ROS message object to a list"
  (cl:list 'RestoreState-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'RestoreState)))
  'RestoreState-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'RestoreState)))
  'RestoreState-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'RestoreState)))
  "Returns string type for a service object of type '<RestoreState>"
  "quad_sim/RestoreState")