; Auto-generated. Do not edit!


(cl:in-package quad_control-srv)


;//! \htmlinclude Advance-request.msg.html

(cl:defclass <Advance-request> (roslisp-msg-protocol:ros-message)
  ((steps
    :reader steps
    :initarg :steps
    :type cl:integer
    :initform 0)
   (hold_steps
    :reader hold_steps
    :initarg :hold_steps
    :type cl:integer
    :initform 0)
   (timeout
    :reader timeout
    :initarg :timeout
    :type cl:float
    :initform 0.0))
)

(cl:defclass Advance-request (<Advance-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <Advance-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'Advance-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<Advance-request> is deprecated: use quad_control-srv:Advance-request instead.")))

(cl:ensure-generic-function 'steps-val :lambda-list '(m))
(cl:defmethod steps-val ((m <Advance-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:steps-val is deprecated.  Use quad_control-srv:steps instead.")
  (steps m))

(cl:ensure-generic-function 'hold_steps-val :lambda-list '(m))
(cl:defmethod hold_steps-val ((m <Advance-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:hold_steps-val is deprecated.  Use quad_control-srv:hold_steps instead.")
  (hold_steps m))

(cl:ensure-generic-function 'timeout-val :lambda-list '(m))
(cl:defmethod timeout-val ((m <Advance-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:timeout-val is deprecated.  Use quad_control-srv:timeout instead.")
  (timeout m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <Advance-request>) ostream)
  "Serializes a message object of type '<Advance-request>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'hold_steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'hold_steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'hold_steps)) ostream)
  (cl:write-byte (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'hold_steps)) ostream)
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
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <Advance-request>) istream)
  "Deserializes a message object of type '<Advance-request>"
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 0) (cl:slot-value msg 'hold_steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) (cl:slot-value msg 'hold_steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) (cl:slot-value msg 'hold_steps)) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) (cl:slot-value msg 'hold_steps)) (cl:read-byte istream))
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
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<Advance-request>)))
  "Returns string type for a service object of type '<Advance-request>"
  "quad_control/AdvanceRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Advance-request)))
  "Returns string type for a service object of type 'Advance-request"
  "quad_control/AdvanceRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<Advance-request>)))
  "Returns md5sum for a message object of type '<Advance-request>"
  "afcba70b4053d85827b1acb8d8d34deb")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'Advance-request)))
  "Returns md5sum for a message object of type 'Advance-request"
  "afcba70b4053d85827b1acb8d8d34deb")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<Advance-request>)))
  "Returns full string definition for message of type '<Advance-request>"
  (cl:format cl:nil "# Moves simulated time by one control interval: the command of the odometry answered last takes effect in it.~%uint32 steps                     # length in physics steps~%uint32 hold_steps                # of which the first ones still fly with the old command (lock-step only)~%float64 timeout                  # [s] of wall time for the controller's command to arrive~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'Advance-request)))
  "Returns full string definition for message of type 'Advance-request"
  (cl:format cl:nil "# Moves simulated time by one control interval: the command of the odometry answered last takes effect in it.~%uint32 steps                     # length in physics steps~%uint32 hold_steps                # of which the first ones still fly with the old command (lock-step only)~%float64 timeout                  # [s] of wall time for the controller's command to arrive~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <Advance-request>))
  (cl:+ 0
     4
     4
     8
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <Advance-request>))
  "Converts a ROS message object to a list"
  (cl:list 'Advance-request
    (cl:cons ':steps (steps msg))
    (cl:cons ':hold_steps (hold_steps msg))
    (cl:cons ':timeout (timeout msg))
))
;//! \htmlinclude Advance-response.msg.html

(cl:defclass <Advance-response> (roslisp-msg-protocol:ros-message)
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
   (stamp
    :reader stamp
    :initarg :stamp
    :type cl:real
    :initform 0)
   (odometry
    :reader odometry
    :initarg :odometry
    :type nav_msgs-msg:Odometry
    :initform (cl:make-instance 'nav_msgs-msg:Odometry))
   (motor_speed
    :reader motor_speed
    :initarg :motor_speed
    :type mav_msgs-msg:Actuators
    :initform (cl:make-instance 'mav_msgs-msg:Actuators))
   (service_delay
    :reader service_delay
    :initarg :service_delay
    :type cl:float
    :initform 0.0)
   (wait
    :reader wait
    :initarg :wait
    :type cl:float
    :initform 0.0)
   (estimated_service_delay
    :reader estimated_service_delay
    :initarg :estimated_service_delay
    :type cl:float
    :initform 0.0))
)

(cl:defclass Advance-response (<Advance-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <Advance-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'Advance-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<Advance-response> is deprecated: use quad_control-srv:Advance-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:success-val is deprecated.  Use quad_control-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:message-val is deprecated.  Use quad_control-srv:message instead.")
  (message m))

(cl:ensure-generic-function 'stamp-val :lambda-list '(m))
(cl:defmethod stamp-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:stamp-val is deprecated.  Use quad_control-srv:stamp instead.")
  (stamp m))

(cl:ensure-generic-function 'odometry-val :lambda-list '(m))
(cl:defmethod odometry-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:odometry-val is deprecated.  Use quad_control-srv:odometry instead.")
  (odometry m))

(cl:ensure-generic-function 'motor_speed-val :lambda-list '(m))
(cl:defmethod motor_speed-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:motor_speed-val is deprecated.  Use quad_control-srv:motor_speed instead.")
  (motor_speed m))

(cl:ensure-generic-function 'service_delay-val :lambda-list '(m))
(cl:defmethod service_delay-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:service_delay-val is deprecated.  Use quad_control-srv:service_delay instead.")
  (service_delay m))

(cl:ensure-generic-function 'wait-val :lambda-list '(m))
(cl:defmethod wait-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:wait-val is deprecated.  Use quad_control-srv:wait instead.")
  (wait m))

(cl:ensure-generic-function 'estimated_service_delay-val :lambda-list '(m))
(cl:defmethod estimated_service_delay-val ((m <Advance-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:estimated_service_delay-val is deprecated.  Use quad_control-srv:estimated_service_delay instead.")
  (estimated_service_delay m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <Advance-response>) ostream)
  "Serializes a message object of type '<Advance-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
  (cl:let ((__sec (cl:floor (cl:slot-value msg 'stamp)))
        (__nsec (cl:round (cl:* 1e9 (cl:- (cl:slot-value msg 'stamp) (cl:floor (cl:slot-value msg 'stamp)))))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 0) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __nsec) ostream))
  (roslisp-msg-protocol:serialize (cl:slot-value msg 'odometry) ostream)
  (roslisp-msg-protocol:serialize (cl:slot-value msg 'motor_speed) ostream)
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'service_delay))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'wait))))
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
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <Advance-response>) istream)
  "Deserializes a message object of type '<Advance-response>"
    (cl:setf (cl:slot-value msg 'success) (cl:not (cl:zerop (cl:read-byte istream))))
    (cl:let ((__ros_str_len 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __ros_str_len) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'message) (cl:make-string __ros_str_len))
      (cl:dotimes (__ros_str_idx __ros_str_len msg)
        (cl:setf (cl:char (cl:slot-value msg 'message) __ros_str_idx) (cl:code-char (cl:read-byte istream)))))
    (cl:let ((__sec 0) (__nsec 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 0) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __nsec) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'stamp) (cl:+ (cl:coerce __sec 'cl:double-float) (cl:/ __nsec 1e9))))
  (roslisp-msg-protocol:deserialize (cl:slot-value msg 'odometry) istream)
  (roslisp-msg-protocol:deserialize (cl:slot-value msg 'motor_speed) istream)
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'service_delay) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'wait) (roslisp-utils:decode-double-float-bits bits)))
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
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<Advance-response>)))
  "Returns string type for a service object of type '<Advance-response>"
  "quad_control/AdvanceResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Advance-response)))
  "Returns string type for a service object of type 'Advance-response"
  "quad_control/AdvanceResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<Advance-response>)))
  "Returns md5sum for a message object of type '<Advance-response>"
  "afcba70b4053d85827b1acb8d8d34deb")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'Advance-response)))
  "Returns md5sum for a message object of type 'Advance-response"
  "afcba70b4053d85827b1acb8d8d34deb")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<Advance-response>)))
  "Returns full string definition for message of type '<Advance-response>"
  (cl:format cl:nil "bool success~%string message                   # what is wrong and what to do, when not; of the first ground contact, when there was one~%time stamp                       # of the state at the interval's end~%nav_msgs/Odometry odometry~%mav_msgs/Actuators motor_speed~%float64 service_delay            # [s] lock-step: wall time of the step; wall-clock: x^noise = dT_sim - dT_ctrl~%float64 wait                     # dT_ctrl [s]: wall time between unpause and pause; 0 in lock-step~%float64 estimated_service_delay  # [s] forgetting-factor mean after this interval; 0 in lock-step~%~%~%================================================================================~%MSG: nav_msgs/Odometry~%# This represents an estimate of a position and velocity in free space.  ~%# The pose in this message should be specified in the coordinate frame given by header.frame_id.~%# The twist in this message should be specified in the coordinate frame given by the child_frame_id~%Header header~%string child_frame_id~%geometry_msgs/PoseWithCovariance pose~%geometry_msgs/TwistWithCovariance twist~%~%================================================================================~%MSG: std_msgs/Header~%# Standard metadata for higher-level stamped data types.~%# This is generally used to communicate timestamped data ~%# in a particular coordinate frame.~%# ~%# sequence ID: consecutively increasing ID ~%uint32 seq~%#Two-integer timestamp that is expressed as:~%# * stamp.sec: seconds (stamp_secs) since epoch (in Python the variable is called 'secs')~%# * stamp.nsec: nanoseconds since stamp_secs (in Python the variable is called 'nsecs')~%# time-handling sugar is provided by the client library~%time stamp~%#Frame this data is associated with~%string frame_id~%~%================================================================================~%MSG: geometry_msgs/PoseWithCovariance~%# This represents a pose in free space with uncertainty.~%~%Pose pose~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Pose~%# A representation of pose in free space, composed of position and orientation. ~%Point position~%Quaternion orientation~%~%================================================================================~%MSG: geometry_msgs/Point~%# This contains the position of a point in free space~%float64 x~%float64 y~%float64 z~%~%================================================================================~%MSG: geometry_msgs/Quaternion~%# This represents an orientation in free space in quaternion form.~%~%float64 x~%float64 y~%float64 z~%float64 w~%~%================================================================================~%MSG: geometry_msgs/TwistWithCovariance~%# This expresses velocity in free space with uncertainty.~%~%Twist twist~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Twist~%# This expresses velocity in free space broken into its linear and angular parts.~%Vector3  linear~%Vector3  angular~%~%================================================================================~%MSG: geometry_msgs/Vector3~%# This represents a vector in free space. ~%# It is only meant to represent a direction. Therefore, it does not~%# make sense to apply a translation to it (e.g., when applying a ~%# generic rigid transformation to a Vector3, tf2 will only apply the~%# rotation). If you want your data to be translatable too, use the~%# geometry_msgs/Point message instead.~%~%float64 x~%float64 y~%float64 z~%================================================================================~%MSG: mav_msgs/Actuators~%# Commands to, or measurements of, a vehicle's actuators. Entries belong to rotors by index.~%std_msgs/Header header~%float64[] angles               # servo angles [rad]~%float64[] angular_velocities   # rotor speeds [rad/s]~%float64[] normalized           # everything else, scaled to [-1, 1]~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'Advance-response)))
  "Returns full string definition for message of type 'Advance-response"
  (cl:format cl:nil "bool success~%string message                   # what is wrong and what to do, when not; of the first ground contact, when there was one~%time stamp                       # of the state at the interval's end~%nav_msgs/Odometry odometry~%mav_msgs/Actuators motor_speed~%float64 service_delay            # [s] lock-step: wall time of the step; wall-clock: x^noise = dT_sim - dT_ctrl~%float64 wait                     # dT_ctrl [s]: wall time between unpause and pause; 0 in lock-step~%float64 estimated_service_delay  # [s] forgetting-factor mean after this interval; 0 in lock-step~%~%~%================================================================================~%MSG: nav_msgs/Odometry~%# This represents an estimate of a position and velocity in free space.  ~%# The pose in this message should be specified in the coordinate frame given by header.frame_id.~%# The twist in this message should be specified in the coordinate frame given by the child_frame_id~%Header header~%string child_frame_id~%geometry_msgs/PoseWithCovariance pose~%geometry_msgs/TwistWithCovariance twist~%~%================================================================================~%MSG: std_msgs/Header~%# Standard metadata for higher-level stamped data types.~%# This is generally used to communicate timestamped data ~%# in a particular coordinate frame.~%# ~%# sequence ID: consecutively increasing ID ~%uint32 seq~%#Two-integer timestamp that is expressed as:~%# * stamp.sec: seconds (stamp_secs) since epoch (in Python the variable is called 'secs')~%# * stamp.nsec: nanoseconds since stamp_secs (in Python the variable is called 'nsecs')~%# time-handling sugar is provided by the client library~%time stamp~%#Frame this data is associated with~%string frame_id~%~%================================================================================~%MSG: geometry_msgs/PoseWithCovariance~%# This represents a pose in free space with uncertainty.~%~%Pose pose~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Pose~%# A representation of pose in free space, composed of position and orientation. ~%Point position~%Quaternion orientation~%~%================================================================================~%MSG: geometry_msgs/Point~%# This contains the position of a point in free space~%float64 x~%float64 y~%float64 z~%~%================================================================================~%MSG: geometry_msgs/Quaternion~%# This represents an orientation in free space in quaternion form.~%~%float64 x~%float64 y~%float64 z~%float64 w~%~%================================================================================~%MSG: geometry_msgs/TwistWithCovariance~%# This expresses velocity in free space with uncertainty.~%~%Twist twist~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Twist~%# This expresses velocity in free space broken into its linear and angular parts.~%Vector3  linear~%Vector3  angular~%~%================================================================================~%MSG: geometry_msgs/Vector3~%# This represents a vector in free space. ~%# It is only meant to represent a direction. Therefore, it does not~%# make sense to apply a translation to it (e.g., when applying a ~%# generic rigid transformation to a Vector3, tf2 will only apply the~%# rotation). If you want your data to be translatable too, use the~%# geometry_msgs/Point message instead.~%~%float64 x~%float64 y~%float64 z~%================================================================================~%MSG: mav_msgs/Actuators~%# Commands to, or measurements of, a vehicle's actuators. Entries belong to rotors by index.~%std_msgs/Header header~%float64[] angles               # servo angles [rad]~%float64[] angular_velocities   # rotor speeds [rad/s]~%float64[] normalized           # everything else, scaled to [-1, 1]~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <Advance-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
     8
     (roslisp-msg-protocol:serialization-length (cl:slot-value msg 'odometry))
     (roslisp-msg-protocol:serialization-length (cl:slot-value msg 'motor_speed))
     8
     8
     8
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <Advance-response>))
  "Converts a ROS message object to a list"
  (cl:list 'Advance-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
    (cl:cons ':stamp (stamp msg))
    (cl:cons ':odometry (odometry msg))
    (cl:cons ':motor_speed (motor_speed msg))
    (cl:cons ':service_delay (service_delay msg))
    (cl:cons ':wait (wait msg))
    (cl:cons ':estimated_service_delay (estimated_service_delay msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'Advance)))
  'Advance-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'Advance)))
  'Advance-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Advance)))
  "Returns string type for a service object of type '<Advance>"
  "quad_control/Advance")