; Auto-generated. Do not edit!


(cl:in-package quad_control-srv)


;//! \htmlinclude Begin-request.msg.html

(cl:defclass <Begin-request> (roslisp-msg-protocol:ros-message)
  ((timeout
    :reader timeout
    :initarg :timeout
    :type cl:float
    :initform 0.0))
)

(cl:defclass Begin-request (<Begin-request>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <Begin-request>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'Begin-request)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<Begin-request> is deprecated: use quad_control-srv:Begin-request instead.")))

(cl:ensure-generic-function 'timeout-val :lambda-list '(m))
(cl:defmethod timeout-val ((m <Begin-request>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:timeout-val is deprecated.  Use quad_control-srv:timeout instead.")
  (timeout m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <Begin-request>) ostream)
  "Serializes a message object of type '<Begin-request>"
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
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <Begin-request>) istream)
  "Deserializes a message object of type '<Begin-request>"
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
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<Begin-request>)))
  "Returns string type for a service object of type '<Begin-request>"
  "quad_control/BeginRequest")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Begin-request)))
  "Returns string type for a service object of type 'Begin-request"
  "quad_control/BeginRequest")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<Begin-request>)))
  "Returns md5sum for a message object of type '<Begin-request>"
  "e839ee468e5b40c11578390e97ff45e0")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'Begin-request)))
  "Returns md5sum for a message object of type 'Begin-request"
  "e839ee468e5b40c11578390e97ff45e0")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<Begin-request>)))
  "Returns full string definition for message of type '<Begin-request>"
  (cl:format cl:nil "# Begins a flight: pauses and resets the simulation and the statistics of the intervals, and reads the first state.~%float64 timeout                  # [s] of wall time for the simulator to answer~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'Begin-request)))
  "Returns full string definition for message of type 'Begin-request"
  (cl:format cl:nil "# Begins a flight: pauses and resets the simulation and the statistics of the intervals, and reads the first state.~%float64 timeout                  # [s] of wall time for the simulator to answer~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <Begin-request>))
  (cl:+ 0
     8
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <Begin-request>))
  "Converts a ROS message object to a list"
  (cl:list 'Begin-request
    (cl:cons ':timeout (timeout msg))
))
;//! \htmlinclude Begin-response.msg.html

(cl:defclass <Begin-response> (roslisp-msg-protocol:ros-message)
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
    :initform (cl:make-instance 'mav_msgs-msg:Actuators)))
)

(cl:defclass Begin-response (<Begin-response>)
  ())

(cl:defmethod cl:initialize-instance :after ((m <Begin-response>) cl:&rest args)
  (cl:declare (cl:ignorable args))
  (cl:unless (cl:typep m 'Begin-response)
    (roslisp-msg-protocol:msg-deprecation-warning "using old message class name quad_control-srv:<Begin-response> is deprecated: use quad_control-srv:Begin-response instead.")))

(cl:ensure-generic-function 'success-val :lambda-list '(m))
(cl:defmethod success-val ((m <Begin-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:success-val is deprecated.  Use quad_control-srv:success instead.")
  (success m))

(cl:ensure-generic-function 'message-val :lambda-list '(m))
(cl:defmethod message-val ((m <Begin-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:message-val is deprecated.  Use quad_control-srv:message instead.")
  (message m))

(cl:ensure-generic-function 'stamp-val :lambda-list '(m))
(cl:defmethod stamp-val ((m <Begin-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:stamp-val is deprecated.  Use quad_control-srv:stamp instead.")
  (stamp m))

(cl:ensure-generic-function 'odometry-val :lambda-list '(m))
(cl:defmethod odometry-val ((m <Begin-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:odometry-val is deprecated.  Use quad_control-srv:odometry instead.")
  (odometry m))

(cl:ensure-generic-function 'motor_speed-val :lambda-list '(m))
(cl:defmethod motor_speed-val ((m <Begin-response>))
  (roslisp-msg-protocol:msg-deprecation-warning "Using old-style slot reader quad_control-srv:motor_speed-val is deprecated.  Use quad_control-srv:motor_speed instead.")
  (motor_speed m))
(cl:defmethod roslisp-msg-protocol:serialize ((msg <Begin-response>) ostream)
  "Serializes a message object of type '<Begin-response>"
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
)
(cl:defmethod roslisp-msg-protocol:deserialize ((msg <Begin-response>) istream)
  "Deserializes a message object of type '<Begin-response>"
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
  msg
)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql '<Begin-response>)))
  "Returns string type for a service object of type '<Begin-response>"
  "quad_control/BeginResponse")
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Begin-response)))
  "Returns string type for a service object of type 'Begin-response"
  "quad_control/BeginResponse")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql '<Begin-response>)))
  "Returns md5sum for a message object of type '<Begin-response>"
  "e839ee468e5b40c11578390e97ff45e0")
(cl:defmethod roslisp-msg-protocol:md5sum ((type (cl:eql 'Begin-response)))
  "Returns md5sum for a message object of type 'Begin-response"
  "e839ee468e5b40c11578390e97ff45e0")
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql '<Begin-response>)))
  "Returns full string definition for message of type '<Begin-response>"
  (cl:format cl:nil "bool success~%string message                   # what is wrong and what to do, when not; of the first ground contact, when there was one~%time stamp                       # of the state, as in odometry.header~%nav_msgs/Odometry odometry~%mav_msgs/Actuators motor_speed   # signed, as on the topic motor_speed~%~%~%================================================================================~%MSG: nav_msgs/Odometry~%# This represents an estimate of a position and velocity in free space.  ~%# The pose in this message should be specified in the coordinate frame given by header.frame_id.~%# The twist in this message should be specified in the coordinate frame given by the child_frame_id~%Header header~%string child_frame_id~%geometry_msgs/PoseWithCovariance pose~%geometry_msgs/TwistWithCovariance twist~%~%================================================================================~%MSG: std_msgs/Header~%# Standard metadata for higher-level stamped data types.~%# This is generally used to communicate timestamped data ~%# in a particular coordinate frame.~%# ~%# sequence ID: consecutively increasing ID ~%uint32 seq~%#Two-integer timestamp that is expressed as:~%# * stamp.sec: seconds (stamp_secs) since epoch (in Python the variable is called 'secs')~%# * stamp.nsec: nanoseconds since stamp_secs (in Python the variable is called 'nsecs')~%# time-handling sugar is provided by the client library~%time stamp~%#Frame this data is associated with~%string frame_id~%~%================================================================================~%MSG: geometry_msgs/PoseWithCovariance~%# This represents a pose in free space with uncertainty.~%~%Pose pose~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Pose~%# A representation of pose in free space, composed of position and orientation. ~%Point position~%Quaternion orientation~%~%================================================================================~%MSG: geometry_msgs/Point~%# This contains the position of a point in free space~%float64 x~%float64 y~%float64 z~%~%================================================================================~%MSG: geometry_msgs/Quaternion~%# This represents an orientation in free space in quaternion form.~%~%float64 x~%float64 y~%float64 z~%float64 w~%~%================================================================================~%MSG: geometry_msgs/TwistWithCovariance~%# This expresses velocity in free space with uncertainty.~%~%Twist twist~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Twist~%# This expresses velocity in free space broken into its linear and angular parts.~%Vector3  linear~%Vector3  angular~%~%================================================================================~%MSG: geometry_msgs/Vector3~%# This represents a vector in free space. ~%# It is only meant to represent a direction. Therefore, it does not~%# make sense to apply a translation to it (e.g., when applying a ~%# generic rigid transformation to a Vector3, tf2 will only apply the~%# rotation). If you want your data to be translatable too, use the~%# geometry_msgs/Point message instead.~%~%float64 x~%float64 y~%float64 z~%================================================================================~%MSG: mav_msgs/Actuators~%# Commands to, or measurements of, a vehicle's actuators. Entries belong to rotors by index.~%std_msgs/Header header~%float64[] angles               # servo angles [rad]~%float64[] angular_velocities   # rotor speeds [rad/s]~%float64[] normalized           # everything else, scaled to [-1, 1]~%~%~%"))
(cl:defmethod roslisp-msg-protocol:message-definition ((type (cl:eql 'Begin-response)))
  "Returns full string definition for message of type 'Begin-response"
  (cl:format cl:nil "bool success~%string message                   # what is wrong and what to do, when not; of the first ground contact, when there was one~%time stamp                       # of the state, as in odometry.header~%nav_msgs/Odometry odometry~%mav_msgs/Actuators motor_speed   # signed, as on the topic motor_speed~%~%~%================================================================================~%MSG: nav_msgs/Odometry~%# This represents an estimate of a position and velocity in free space.  ~%# The pose in this message should be specified in the coordinate frame given by header.frame_id.~%# The twist in this message should be specified in the coordinate frame given by the child_frame_id~%Header header~%string child_frame_id~%geometry_msgs/PoseWithCovariance pose~%geometry_msgs/TwistWithCovariance twist~%~%================================================================================~%MSG: std_msgs/Header~%# Standard metadata for higher-level stamped data types.~%# This is generally used to communicate timestamped data ~%# in a particular coordinate frame.~%# ~%# sequence ID: consecutively increasing ID ~%uint32 seq~%#Two-integer timestamp that is expressed as:~%# * stamp.sec: seconds (stamp_secs) since epoch (in Python the variable is called 'secs')~%# * stamp.nsec: nanoseconds since stamp_secs (in Python the variable is called 'nsecs')~%# time-handling sugar is provided by the client library~%time stamp~%#Frame this data is associated with~%string frame_id~%~%================================================================================~%MSG: geometry_msgs/PoseWithCovariance~%# This represents a pose in free space with uncertainty.~%~%Pose pose~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Pose~%# A representation of pose in free space, composed of position and orientation. ~%Point position~%Quaternion orientation~%~%================================================================================~%MSG: geometry_msgs/Point~%# This contains the position of a point in free space~%float64 x~%float64 y~%float64 z~%~%================================================================================~%MSG: geometry_msgs/Quaternion~%# This represents an orientation in free space in quaternion form.~%~%float64 x~%float64 y~%float64 z~%float64 w~%~%================================================================================~%MSG: geometry_msgs/TwistWithCovariance~%# This expresses velocity in free space with uncertainty.~%~%Twist twist~%~%# Row-major representation of the 6x6 covariance matrix~%# The orientation parameters use a fixed-axis representation.~%# In order, the parameters are:~%# (x, y, z, rotation about X axis, rotation about Y axis, rotation about Z axis)~%float64[36] covariance~%~%================================================================================~%MSG: geometry_msgs/Twist~%# This expresses velocity in free space broken into its linear and angular parts.~%Vector3  linear~%Vector3  angular~%~%================================================================================~%MSG: geometry_msgs/Vector3~%# This represents a vector in free space. ~%# It is only meant to represent a direction. Therefore, it does not~%# make sense to apply a translation to it (e.g., when applying a ~%# generic rigid transformation to a Vector3, tf2 will only apply the~%# rotation). If you want your data to be translatable too, use the~%# geometry_msgs/Point message instead.~%~%float64 x~%float64 y~%float64 z~%================================================================================~%MSG: mav_msgs/Actuators~%# Commands to, or measurements of, a vehicle's actuators. Entries belong to rotors by index.~%std_msgs/Header header~%float64[] angles               # servo angles [rad]~%float64[] angular_velocities   # rotor speeds [rad/s]~%float64[] normalized           # everything else, scaled to [-1, 1]~%~%~%"))
(cl:defmethod roslisp-msg-protocol:serialization-length ((msg <Begin-response>))
  (cl:+ 0
     1
     4 (cl:length (cl:slot-value msg 'message))
     8
     (roslisp-msg-protocol:serialization-length (cl:slot-value msg 'odometry))
     (roslisp-msg-protocol:serialization-length (cl:slot-value msg 'motor_speed))
))
(cl:defmethod roslisp-msg-protocol:ros-message-to-list ((msg <Begin-response>))
  "Converts a ROS message object to a list"
  (cl:list 'Begin-response
    (cl:cons ':success (success msg))
    (cl:cons ':message (message msg))
    (cl:cons ':stamp (stamp msg))
    (cl:cons ':odometry (odometry msg))
    (cl:cons ':motor_speed (motor_speed msg))
))
(cl:defmethod roslisp-msg-protocol:service-request-type ((msg (cl:eql 'Begin)))
  'Begin-request)
(cl:defmethod roslisp-msg-protocol:service-response-type ((msg (cl:eql 'Begin)))
  'Begin-response)
(cl:defmethod roslisp-msg-protocol:ros-datatype ((msg (cl:eql 'Begin)))
  "Returns string type for a service object of type '<Begin>"
  "quad_control/Begin")