; Auto-generated. Do not edit!


(cl:in-package quad_control-srv)


;//! \htmlinclude SetFlightPlan-request.msg.html

(cl:defclass <SetFlightPlan-request> (roslisp-msg-protocol:ros-message)
  ((x
    :reader x
    :initarg :x
    :type cl:float
    :initform 0.0)
   (y
    :reader y
    :initarg :y
    :type cl:float
    :initform 0.0)
   (z
    :reader z
    :initarg :z
    :type cl:float
    :initform 0.0)
   (yaw
    :reader yaw
    :initarg :yaw
    :type cl:float
    :initform 0.0)
   (feed_forward_mass
    :reader feed_forward_mass
    :initarg :feed_forward_mass
    :type cl:float
    :initform 0.0)
   (initial_altitude_effort
    :reader initial_altitude_effort
    :initarg :initial_altitude_effort
    :type cl:float
    :initform 0.0)
   (exploration_start
    :reader exploration_start
    :initarg :exploration_start
    :type cl:real
    :initform 0)
   (exploration_signal
    :reader exploration_signal
    :initarg :exploration_signal
    :type (cl:vector cl:float)
   :initform (cl:make-array 0 :element-type 'cl:float :initial-element 0.0)))
)

(cl:defclass SetFlightPlan-request (<SetFlightPlan-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <SetFlightPlan-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'SetFlightPlan-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<SetFlightPlan-request> is deprecated: use quad_control-srv:SetFlightPlan-request instead.")))

(cl:ensure-generic-function 'x-val :lambda-list '(m))
(cl:defmethod x-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:x-val is deprecated.  Use quad_control-srv:x instead.")
  (x m))

(cl:ensure-generic-function 'y-val :lambda-list '(m))
(cl:defmethod y-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:y-val is deprecated.  Use quad_control-srv:y instead.")
  (y m))

(cl:ensure-generic-function 'z-val :lambda-list '(m))
(cl:defmethod z-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:z-val is deprecated.  Use quad_control-srv:z instead.")
  (z m))

(cl:ensure-generic-function 'yaw-val :lambda-list '(m))
(cl:defmethod yaw-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:yaw-val is deprecated.  Use quad_control-srv:yaw instead.")
  (yaw m))

(cl:ensure-generic-function 'feed_forward_mass-val :lambda-list '(m))
(cl:defmethod feed_forward_mass-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:feed_forward_mass-val is deprecated.  Use quad_control-srv:feed_forward_mass instead.")
  (feed_forward_mass m))

(cl:ensure-generic-function 'initial_altitude_effort-val :lambda-list '(m))
(cl:defmethod initial_altitude_effort-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:initial_altitude_effort-val is deprecated.  Use quad_control-srv:initial_altitude_effort instead.")
  (initial_altitude_effort m))

(cl:ensure-generic-function 'exploration_start-val :lambda-list '(m))
(cl:defmethod exploration_start-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:exploration_start-val is deprecated.  Use quad_control-srv:exploration_start instead.")
  (exploration_start m))

(cl:ensure-generic-function 'exploration_signal-val :lambda-list '(m))
(cl:defmethod exploration_signal-val ((m <SetFlightPlan-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:exploration_signal-val is deprecated.  Use quad_control-srv:exploration_signal instead.")
  (exploration_signal m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <SetFlightPlan-request>) ostream)
  "Serializes a message object of type '<SetFlightPlan-request>"
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'x))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'y))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'z))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'yaw))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'feed_forward_mass))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((bits (roslisp-utils:encode-double-float-bits (cl:slot-value msg 'initial_altitude_effort))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream))
  (cl:let ((__sec (cl:floor (cl:slot-value msg 'exploration_start)))
        (__nsec (cl:round (cl:* 1e9 (cl:- (cl:slot-value msg 'exploration_start) (cl:floor (cl:slot-value msg 'exploration_start)))))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __sec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 0) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __nsec) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __nsec) ostream))
  (cl:let ((__ros_arr_len (cl:length (cl:slot-value msg 'exploration_signal))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_arr_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_arr_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_arr_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_arr_len) ostream))
  (cl:map cl:nil #'(cl:lambda (ele) (cl:let ((bits (roslisp-utils:encode-double-float-bits ele)))
    (cl:write-byte (cl:ldb (cl:byte 8 0) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 32) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 40) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 48) bits) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 56) bits) ostream)))
   (cl:slot-value msg 'exploration_signal))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <SetFlightPlan-request>) istream)
  "Deserializes a message object of type '<SetFlightPlan-request>"
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'x) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'y) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'z) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'yaw) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'feed_forward_mass) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:slot-value msg 'initial_altitude_effort) (roslisp-utils:decode-double-float-bits bits)))
    (cl:let ((__sec 0) (__nsec 0))
      (cl:setf (cl:ldb (cl:byte 8 0) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __sec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 0) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) __nsec) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) __nsec) (cl:read-byte istream))
      (cl:setf (cl:slot-value msg 'exploration_start) (cl:+ (cl:coerce __sec 'cl:double-float) (cl:/ __nsec 1e9))))
  (cl:let ((__ros_arr_len 0))
    (cl:setf (cl:ldb (cl:byte 8 0) __ros_arr_len) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 8) __ros_arr_len) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 16) __ros_arr_len) (cl:read-byte istream))
    (cl:setf (cl:ldb (cl:byte 8 24) __ros_arr_len) (cl:read-byte istream))
  (cl:setf (cl:slot-value msg 'exploration_signal) (cl:make-array __ros_arr_len))
  (cl:let ((vals (cl:slot-value msg 'exploration_signal)))
    (cl:dotimes (i __ros_arr_len)
    (cl:let ((bits 0))
      (cl:setf (cl:ldb (cl:byte 8 0) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 8) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 16) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 24) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 32) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 40) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 48) bits) (cl:read-byte istream))
      (cl:setf (cl:ldb (cl:byte 8 56) bits) (cl:read-byte istream))
    (cl:setf (cl:aref vals i) (roslisp-utils:decode-double-float-bits bits))))))
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<SetFlightPlan-request>)))
  "Returns string type for a service object of type '<SetFlightPlan-request>"
  "quad_control/SetFlightPlanRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SetFlightPlan-request)))
  "Returns string type for a service object of type 'SetFlightPlan-request"
  "quad_control/SetFlightPlanRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<SetFlightPlan-request>)))
  "Returns md5sum for a message object of type '<SetFlightPlan-request>"
  "b0e464dae6016eca6fa4aa27610f111d")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'SetFlightPlan-request)))
  "Returns md5sum for a message object of type 'SetFlightPlan-request"
  "b0e464dae6016eca6fa4aa27610f111d")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<SetFlightPlan-request>)))
  "Returns full string definition for message of type '<SetFlightPlan-request>"
  (cl:format cl:nil "# Hands a whole flight to the controllers before it begins; they start again with the next odometry.~%float64 x                        # references: position [m] (x, y only with the position loop) ...~%float64 y~%float64 z~%float64 yaw                      # ... and heading [rad]~%float64 feed_forward_mass        # m_hat0 [kg]; feed-forward is m_hat0 * gravity of the configuration~%float64 initial_altitude_effort  # T_eff of the altitude integral at the first sample [N]; (m - m_hat0) g is equilibrium~%time exploration_start           # the first odometry stamped at or after this takes sample 0 of the signal~%float64[] exploration_signal     # T_eff [N], one sample an odometry; empty: the hold goes on for ever~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'SetFlightPlan-request)))
  "Returns full string definition for message of type 'SetFlightPlan-request"
  (cl:format cl:nil "# Hands a whole flight to the controllers before it begins; they start again with the next odometry.~%float64 x                        # references: position [m] (x, y only with the position loop) ...~%float64 y~%float64 z~%float64 yaw                      # ... and heading [rad]~%float64 feed_forward_mass        # m_hat0 [kg]; feed-forward is m_hat0 * gravity of the configuration~%float64 initial_altitude_effort  # T_eff of the altitude integral at the first sample [N]; (m - m_hat0) g is equilibrium~%time exploration_start           # the first odometry stamped at or after this takes sample 0 of the signal~%float64[] exploration_signal     # T_eff [N], one sample an odometry; empty: the hold goes on for ever~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <SetFlightPlan-request>))
  (cl:+ 0
     8
     8
     8
     8
     8
     8
     8
     4 (cl:reduce #'cl:+ (cl:slot-value msg 'exploration_signal) :key #'(cl:lambda (ele) (cl:declare (cl:ignorable ele)) (cl:+ 8)))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <SetFlightPlan-request>))
  "Converts a ROS message object to a list"
  (cl:list 'SetFlightPlan-request
    (cl:cons ':x (x msg))
    (cl:cons ':y (y msg))
    (cl:cons ':z (z msg))
    (cl:cons ':yaw (yaw msg))
    (cl:cons ':feed_forward_mass (feed_forward_mass msg))
    (cl:cons ':initial_altitude_effort (initial_altitude_effort msg))
    (cl:cons ':exploration_start (exploration_start msg))
    (cl:cons ':exploration_signal (exploration_signal msg))
))
;//! \htmlinclude SetFlightPlan-response.msg.html

(cl:defclass <SetFlightPlan-response> (roslisp-msg-protocol:ros-message)
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

(cl:defclass SetFlightPlan-response (<SetFlightPlan-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <SetFlightPlan-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'SetFlightPlan-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<SetFlightPlan-response> is deprecated: use quad_control-srv:SetFlightPlan-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <SetFlightPlan-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:success-val is deprecated.  Use quad_control-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <SetFlightPlan-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:message-val is deprecated.  Use quad_control-srv:message instead.")
  (message m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <SetFlightPlan-response>) ostream)
  "Serializes a message object of type '<SetFlightPlan-response>"
  (cl:write-byte (cl:ldb (cl:byte 8 0) (cl:if (cl:slot-value msg 'success) 1 0)) ostream)
  (cl:let ((__ros_str_len (cl:length (cl:slot-value msg 'message))))
    (cl:write-byte (cl:ldb (cl:byte 8 0) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 8) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 16) __ros_str_len) ostream)
    (cl:write-byte (cl:ldb (cl:byte 8 24) __ros_str_len) ostream))
  (cl:map cl:nil #'(cl:lambda (c) (cl:write-byte (cl:char-code c) ostream)) (cl:slot-value msg 'message))
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <SetFlightPlan-response>) istream)
  "Deserializes a message object of type '<SetFlightPlan-response>"
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
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<SetFlightPlan-response>)))
  "Returns string type for a service object of type '<SetFlightPlan-response>"
  "quad_control/SetFlightPlanResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SetFlightPlan-response)))
  "Returns string type for a service object of type 'SetFlightPlan-response"
  "quad_control/SetFlightPlanResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<SetFlightPlan-response>)))
  "Returns md5sum for a message object of type '<SetFlightPlan-response>"
  "b0e464dae6016eca6fa4aa27610f111d")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'SetFlightPlan-response)))
  "Returns md5sum for a message object of type 'SetFlightPlan-response"
  "b0e464dae6016eca6fa4aa27610f111d")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<SetFlightPlan-response>)))
  "Returns full string definition for message of type '<SetFlightPlan-response>"
  (cl:format cl:nil "bool success~%string message                   # what is wrong, when not~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'SetFlightPlan-response)))
  "Returns full string definition for message of type 'SetFlightPlan-response"
  (cl:format cl:nil "bool success~%string message                   # what is wrong, when not~%~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <SetFlightPlan-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <SetFlightPlan-response>))
  "Converts a ROS message object to a list"
  (cl:list 'SetFlightPlan-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'SetFlightPlan)))
  'SetFlightPlan-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'SetFlightPlan)))
  'SetFlightPlan-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'SetFlightPlan)))
  "Returns string type for a service object of type '<SetFlightPlan>"
  "quad_control/SetFlightPlan")