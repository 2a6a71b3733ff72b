; Auto-generated. Do not edit!


(cl:in-package quad_control-srv)


;//! \htmlinclude TimingReport-request.msg.html

(cl:defclass <TimingReport-request> (roslisp-msg-protocol:ros-message)
  ((timeout
    :reader timeout
    :initarg :timeout
    :type cl:float
    :initform 0.0))
)

(cl:defclass TimingReport-request (<TimingReport-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <TimingReport-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'TimingReport-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<TimingReport-request> is deprecated: use quad_control-srv:TimingReport-request instead.")))

(cl:ensure-generic-function 'timeout-val :lambda-list '(m))
(cl:defmethod timeout-val ((m <TimingReport-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:timeout-val is deprecated.  Use quad_control-srv:timeout instead.")
  (timeout m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <TimingReport-request>) ostream)
  "Serializes a message object of type '<TimingReport-request>"
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'timeout))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <TimingReport-request>) istream)
  "Deserializes a message object of type '<TimingReport-request>"
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'timeout) (roslisp-utils:decode-double-float-bits bits)))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<TimingReport-request>)))
  "Returns string type for a service object of type '<TimingReport-request>"
  "quad_control/TimingReportRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'TimingReport-request)))
  "Returns string type for a service object of type 'TimingReport-request"
  "quad_control/TimingReportRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<TimingReport-request>)))
  "Returns md5sum for a message object of type '<TimingReport-request>"
  "afdee2b9586e0f02affc31ab971c36b0")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'TimingReport-request)))
  "Returns md5sum for a message object of type 'TimingReport-request"
  "afdee2b9586e0f02affc31ab971c36b0")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<TimingReport-request>)))
  "Returns full string definition for message of type '<TimingReport-request>"
  (cl:format cl:nil "# Ends a flight: waits until the last command has arrived, so that nothing of it reaches the next one, and reports how~%# exact the intervals were.~%float64 timeout                  # [s] of wall time for the last command~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'TimingReport-request)))
  "Returns full string definition for message of type 'TimingReport-request"
  (cl:format cl:nil "# Ends a flight: waits until the last command has arrived, so that nothing of it reaches the next one, and reports how~%# exact the intervals were.~%float64 timeout                  # [s] of wall time for the last command~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <TimingReport-request>))
  (cl:+ 0
     8
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <TimingReport-request>))
  "Converts a ROS message object to a list"
  (cl:list 'TimingReport-request
    (cl:cons ':timeout (timeout msg))
))
;//! \htmlinclude TimingReport-response.msg.html

(cl:defclass <TimingReport-response> (roslisp-msg-protocol:ros-message)
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
   (mode
    :reader mode
    :initarg :mode
    :type cl:string
    :initform "")
   (intervals
    :reader intervals
    :initarg :intervals
    :type cl:integer
    :initform 0)
   (desired
    :reader desired
    :initarg :desired
    :type cl:float
    :initform 0.0)
   (mean
    :reader mean
    :initarg :mean
    :type cl:float
    :initform 0.0)
   (std
    :reader std
    :initarg :std
    :type cl:float
    :initform 0.0)
   (max_abs_error
    :reader max_abs_error
    :initarg :max_abs_error
    :type cl:float
    :initform 0.0)
   (mean_service_delay
    :reader mean_service_delay
    :initarg :mean_service_delay
    :type cl:float
    :initform 0.0)
   (estimated_service_delay
    :reader estimated_service_delay
    :initarg :estimated_service_delay
    :type cl:float
    :initform 0.0))
)

(cl:defclass TimingReport-response (<TimingReport-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <TimingReport-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'TimingReport-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<TimingReport-response> is deprecated: use quad_control-srv:TimingReport-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:success-val is deprecated.  Use quad_control-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:message-val is deprecated.  Use quad_control-srv:message instead.")
  (message m))

(cl:ensure-generic-function 'mode-val :lambda-list '(m))
(cl:defmethod mode-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:mode-val is deprecated.  Use quad_control-srv:mode instead.")
  (mode m))

(cl:ensure-generic-function 'intervals-val :lambda-list '(m))
(cl:defmethod intervals-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:intervals-val is deprecated.  Use quad_control-srv:intervals instead.")
  (intervals m))

(cl:ensure-generic-function 'desired-val :lambda-list '(m))
(cl:defmethod desired-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:desired-val is deprecated.  Use quad_control-srv:desired instead.")
  (desired m))

(cl:ensure-generic-function 'mean-val :lambda-list '(m))
(cl:defmethod mean-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:mean-val is deprecated.  Use quad_control-srv:mean instead.")
  (mean m))

(cl:ensure-generic-function 'std-val :lambda-list '(m))
(cl:defmethod std-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:std-val is deprecated.  Use quad_control-srv:std instead.")
  (std m))

(cl:ensure-generic-function 'max_abs_error-val :lambda-list '(m))
(cl:defmethod max_abs_error-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:max_abs_error-val is deprecated.  Use quad_control-srv:max_abs_error instead.")
  (max_abs_error m))

(cl:ensure-generic-function 'mean_service_delay-val :lambda-list '(m))
(cl:defmethod mean_service_delay-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:mean_service_delay-val is deprecated.  Use quad_control-srv:mean_service_delay instead.")
  (mean_service_delay m))

(cl:ensure-generic-function 'estimated_service_delay-val :lambda-list '(m))
(cl:defmethod estimated_service_delay-val ((m <TimingReport-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:estimated_service_delay-val is deprecated.  Use quad_control-srv:estimated_service_delay instead.")
  (estimated_service_delay m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <TimingReport-response>) ostream)
  "Serializes a message object of type '<TimingReport-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'mode))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'mode))
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'intervals)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'intervals)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'intervals)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'intervals)) ostream)
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'desired))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'mean))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'std))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'max_abs_error))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'mean_service_delay))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'estimated_service_delay))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <TimingReport-response>) istream)
  "Deserializes a message object of type '<TimingReport-response>"
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
      (cl:setf (cl:slot-value msg 'mode) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'mode) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'intervals)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'intervals)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'intervals)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'intervals)) (cl:read-byte istream))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'desired) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'mean) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'std) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'max_abs_error) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'mean_service_delay) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'estimated_service_delay) (roslisp-utils:decode-double-float-bits bits)))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<TimingReport-response>)))
  "Returns string type for a service object of type '<TimingReport-response>"
  "quad_control/TimingReportResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'TimingReport-response)))
  "Returns string type for a service object of type 'TimingReport-response"
  "quad_control/TimingReportResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<TimingReport-response>)))
  "Returns md5sum for a message object of type '<TimingReport-response>"
  "afdee2b9586e0f02affc31ab971c36b0")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'TimingReport-response)))
  "Returns md5sum for a message object of type 'TimingReport-response"
  "afdee2b9586e0f02affc31ab971c36b0")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<TimingReport-response>)))
  "Returns full string definition for message of type '<TimingReport-response>"
  (cl:format cl:nil "bool success~%string message~%string mode                      # lockstep | wallclock~%uint32 intervals~%float64 desired                  # mean of the lengths asked for [s]~%float64 mean                     # of the measured lengths, simulated time [s]~%float64 std                      # of the measured lengths, n - 1 [s]~%float64 max_abs_error            # largest |measured - asked for| [s]~%float64 mean_service_delay       # plain mean of Advance.service_delay [s]~%float64 estimated_service_delay  # forgetting-factor mean after the last interval [s]; 0 in lock-step~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'TimingReport-response)))
  "Returns full string definition for message of type 'TimingReport-response"
  (cl:format cl:nil "bool success~%string message~%string mode                      # lockstep | wallclock~%uint32 intervals~%float64 desired                  # mean of the lengths asked for [s]~%float64 mean                     # of the measured lengths, simulated time [s]~%float64 std                      # of the measured lengths, n - 1 [s]~%float64 max_abs_error            # largest |measured - asked for| [s]~%float64 mean_service_delay       # plain mean of Advance.service_delay [s]~%float64 estimated_service_delay  # forgetting-factor mean after the last interval [s]; 0 in lock-step~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <TimingReport-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
     4 (cl:length (cl:slot-value msg 'mode))
     4
     8
     8
     8
     8
     8
     8
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <TimingReport-response>))
  "Converts a ROS message object to a list"
  (cl:list 'TimingReport-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
    (cl:cons ':mode (mode msg))
    (cl:cons ':intervals (intervals msg))
    (cl:cons ':desired (desired msg))
    (cl:cons ':mean (mean msg))
    (cl:cons ':std (std msg))
    (cl:cons ':max_abs_error (max_abs_error msg))
    (cl:cons ':mean_service_delay (mean_service_delay msg))
    (cl:cons ':estimated_service_delay (estimated_service_delay msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'TimingReport)))
  'TimingReport-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'TimingReport)))
  'TimingReport-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'TimingReport)))
  "Returns string type for a service object of type '<TimingReport>"
  "quad_control/TimingReport")