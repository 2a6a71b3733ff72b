; Auto-generated. Do not edit!


(cl:in-package quad_sim-srv)


;//! \htmlinclude CommandReport-request.msg.html

(cl:defclass <CommandReport-request> (roslisp-msg-protocol:ros-message)
  ((model_name
    :reader model_name
    :initarg :model_name
    :type cl:string
    :initform ""))
)

(cl:defclass CommandReport-request (<CommandReport-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <CommandReport-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'CommandReport-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<CommandReport-request> is deprecated: use quad_sim-srv:CommandReport-request instead.")))

(cl:ensure-generic-function 'model_name-val :lambda-list '(m))
(cl:defmethod model_name-val ((m <CommandReport-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:model_name-val is deprecated.  Use quad_sim-srv:model_name instead.")
  (model_name m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <CommandReport-request>) ostream)
  "Serializes a message object of type '<CommandReport-request>"
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'model_name))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'model_name))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <CommandReport-request>) istream)
  "Deserializes a message object of type '<CommandReport-request>"
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'model_name) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'model_name) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<CommandReport-request>)))
  "Returns string type for a service object of type '<CommandReport-request>"
  "quad_sim/CommandReportRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'CommandReport-request)))
  "Returns string type for a service object of type 'CommandReport-request"
  "quad_sim/CommandReportRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<CommandReport-request>)))
  "Returns md5sum for a message object of type '<CommandReport-request>"
  "7de61f73729da39fd21f9c2b4481ec74")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'CommandReport-request)))
  "Returns md5sum for a message object of type 'CommandReport-request"
  "7de61f73729da39fd21f9c2b4481ec74")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<CommandReport-request>)))
  "Returns full string definition for message of type '<CommandReport-request>"
  (cl:format cl:nil "# What has become of the messages on <model_name>/command/motor_speed since the last reset.~%string model_name       # empty: the first vehicle~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'CommandReport-request)))
  "Returns full string definition for message of type 'CommandReport-request"
  (cl:format cl:nil "# What has become of the messages on <model_name>/command/motor_speed since the last reset.~%string model_name       # empty: the first vehicle~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <CommandReport-request>))
  (cl:+ 0
     4 (cl:length (cl:slot-value msg 'model_name))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <CommandReport-request>))
  "Converts a ROS message object to a list"
  (cl:list 'CommandReport-request
    (cl:cons ':model_name (model_name msg))
))
;//! \htmlinclude CommandReport-response.msg.html

(cl:defclass <CommandReport-response> (roslisp-msg-protocol:ros-message)
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
   (received
    :reader received
    :initarg :received
    :type cl:integer
    :initform 0)
   (wrong_length
    :reader wrong_length
    :initarg :wrong_length
    :type cl:integer
    :initform 0)
   (not_finite
    :reader not_finite
    :initarg :not_finite
    :type cl:integer
    :initform 0)
   (late
    :reader late
    :initarg :late
    :type cl:integer
    :initform 0)
   (negative
    :reader negative
    :initarg :negative
    :type cl:integer
    :initform 0)
   (over_limit
    :reader over_limit
    :initarg :over_limit
    :type cl:integer
    :initform 0)
   (last_problem
    :reader last_problem
    :initarg :last_problem
    :type cl:string
    :initform ""))
)

(cl:defclass CommandReport-response (<CommandReport-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <CommandReport-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'CommandReport-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_sim-srv:<CommandReport-response> is deprecated: use quad_sim-srv:CommandReport-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:success-val is deprecated.  Use quad_sim-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:message-val is deprecated.  Use quad_sim-srv:message instead.")
  (message m))

(cl:ensure-generic-function 'received-val :lambda-list '(m))
(cl:defmethod received-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:received-val is deprecated.  Use quad_sim-srv:received instead.")
  (received m))

(cl:ensure-generic-function 'wrong_length-val :lambda-list '(m))
(cl:defmethod wrong_length-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:wrong_length-val is deprecated.  Use quad_sim-srv:wrong_length instead.")
  (wrong_length m))

(cl:ensure-generic-function 'not_finite-val :lambda-list '(m))
(cl:defmethod not_finite-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:not_finite-val is deprecated.  Use quad_sim-srv:not_finite instead.")
  (not_finite m))

(cl:ensure-generic-function 'late-val :lambda-list '(m))
(cl:defmethod late-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:late-val is deprecated.  Use quad_sim-srv:late instead.")
  (late m))

(cl:ensure-generic-function 'negative-val :lambda-list '(m))
(cl:defmethod negative-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:negative-val is deprecated.  Use quad_sim-srv:negative instead.")
  (negative m))

(cl:ensure-generic-function 'over_limit-val :lambda-list '(m))
(cl:defmethod over_limit-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:over_limit-val is deprecated.  Use quad_sim-srv:over_limit instead.")
  (over_limit m))

(cl:ensure-generic-function 'last_problem-val :lambda-list '(m))
(cl:defmethod last_problem-val ((m <CommandReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_sim-srv:last_problem-val is deprecated.  Use quad_sim-srv:last_problem instead.")
  (last_problem m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <CommandReport-response>) ostream)
  "Serializes a message object of type '<CommandReport-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'received)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'wrong_length)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'not_finite)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'late)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'negative)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'over_limit)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'over_limit)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'last_problem))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'last_problem))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <CommandReport-response>) istream)
  "Deserializes a message object of type '<CommandReport-response>"
    (cl:setf (cl:slot-value msg 'success) (cl:not (cl:zerop (cl:read-byte istream))))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'message) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'message) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'received)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'wrong_length)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'not_finite)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'late)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'negative)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 32) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 40) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 48) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 56) (cl:slot-value msg 'over_limit)) (cl:read-byte istream))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'last_problem) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'last_problem) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<CommandReport-response>)))
  "Returns string type for a service object of type '<CommandReport-response>"
  "quad_sim/CommandReportResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'CommandReport-response)))
  "Returns string type for a service object of type 'CommandReport-response"
  "quad_sim/CommandReportResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<CommandReport-response>)))
  "Returns md5sum for a message object of type '<CommandReport-response>"
  "7de61f73729da39fd21f9c2b4481ec74")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'CommandReport-response)))
  "Returns md5sum for a message object of type 'CommandReport-response"
  "7de61f73729da39fd21f9c2b4481ec74")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<CommandReport-response>)))
  "Returns full string definition for message of type '<CommandReport-response>"
  (cl:format cl:nil "bool success~%string message~%uint64 received~%uint64 wrong_length     # refused: the earlier command stays~%uint64 not_finite       # refused: the earlier command stays~%uint64 late             # refused: answers an odometry older than one already answered~%uint64 negative         # flown with 0 in place of the negative speeds~%uint64 over_limit       # flown with the rotor's maximum in place of what exceeds it~%string last_problem     # the last one of these in words~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'CommandReport-response)))
  "Returns full string definition for message of type 'CommandReport-response"
  (cl:format cl:nil "bool success~%string message~%uint64 received~%uint64 wrong_length     # refused: the earlier command stays~%uint64 not_finite       # refused: the earlier command stays~%uint64 late             # refused: answers an odometry older than one already answered~%uint64 negative         # flown with 0 in place of the negative speeds~%uint64 over_limit       # flown with the rotor's maximum in place of what exceeds it~%string last_problem     # the last one of these in words~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <CommandReport-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
     8
     8
     8
     8
     8
     8
     4 (cl:length (cl:slot-value msg 'last_problem))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <CommandReport-response>))
  "Converts a ROS message object to a list"
  (cl:list 'CommandReport-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
    (cl:cons ':received (received msg))
    (cl:cons ':wrong_length (wrong_length msg))
    (cl:cons ':not_finite (not_finite msg))
    (cl:cons ':late (late msg))
    (cl:cons ':negative (negative msg))
    (cl:cons ':over_limit (over_limit msg))
    (cl:cons ':last_problem (last_problem msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'CommandReport)))
  'CommandReport-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'CommandReport)))
  'CommandReport-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'CommandReport)))
  "Returns string type for a service object of type '<CommandReport>"
  "quad_sim/CommandReport")