// Node attitude_altitude_controller_node: odometry in, command/motor_speed out, its stamp copied.
// References by command/pose and command/trajectory, or a flight plan by service. Parameter:
// ~config.
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <exception>
#include <optional>

#include "conversions.hpp"
#include "spin.hpp"

namespace quad_control {
namespace {

class ControllerNode {
 public:
  explicit ControllerNode(const NodeConfig& config)
      : config_(config),
        controller_(config.vehicle, config.control),
        samples_(config.control.sampling_period),
        private_handle_("~") {
    motor_speed_pub_ =
        handle_.advertise<mav_msgs::Actuators>("command/motor_speed", 1, /*latch=*/true);
    input_pub_ = handle_.advertise<geometry_msgs::WrenchStamped>("control/u", 10);
    feedback_pub_ = handle_.advertise<geometry_msgs::WrenchStamped>("control/u_fb", 10);
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    odometry_sub_ = handle_.subscribe("odometry", 10, &ControllerNode::onOdometry, this, hints);
    rotor_speed_sub_ =
        handle_.subscribe("motor_speed", 10, &ControllerNode::onRotorSpeed, this, hints);
    pose_sub_ = handle_.subscribe("command/pose", 1, &ControllerNode::onPose, this);
    trajectory_sub_ =
        handle_.subscribe("command/trajectory", 1, &ControllerNode::onTrajectory, this);
    plan_srv_ =
        private_handle_.advertiseService("set_flight_plan", &ControllerNode::setFlightPlan, this);
    record_srv_ =
        private_handle_.advertiseService("flight_record", &ControllerNode::flightRecord, this);
  }

 private:
  void onOdometry(const nav_msgs::Odometry::ConstPtr& msg) {
    const quad_sim::Odometry odometry = quad_sim::fromMsg(*msg);
    if (trajectory_) follow(odometry.time_ns);
    if (!controller_.flying()) return;  // neither a plan nor a reference: nothing to fly to
    // A plan is flown sample by sample as the time management deals them; without one the samples
    // are picked here, and in between the last command is answered again.
    const bool sample = samples_.isSample(odometry.time_ns) || planned_;
    const ControlOutput& out = sample || controller_.record().empty() ? controller_.update(odometry)
                                                                      : controller_.record().back();
    motor_speed_pub_.publish(toMsg(out.rotor_speed, msg->header.stamp));
    if (input_pub_.getNumSubscribers() == 0) return;
    input_pub_.publish(toMsg({out.thrust, out.tau_phi, out.tau_theta, out.tau_psi},
                             msg->header.stamp, msg->child_frame_id));
  }

  void onRotorSpeed(const mav_msgs::Actuators::ConstPtr& msg) {
    if (feedback_pub_.getNumSubscribers() == 0) return;
    feedback_pub_.publish(toMsg(controller_.mixer().controlInput(msg->angular_velocities),
                                msg->header.stamp, msg->header.frame_id));
  }

  void onPose(const geometry_msgs::PoseStamped::ConstPtr& msg) {
    trajectory_.reset();
    moveTo(fromMsg(msg->pose));
  }

  void onTrajectory(const trajectory_msgs::MultiDOFJointTrajectory::ConstPtr& msg) try {
    trajectory_ = fromMsg(*msg);
  } catch (const std::invalid_argument& e) {
    ROS_ERROR("command/trajectory ignored: %s", e.what());
  }

  void follow(std::int64_t time_ns) {
    const std::optional<References> references = trajectory_->at(time_ns);
    if (references) moveTo(*references);
  }

  // Without a plan the vehicle's own mass is the feed-forward, and the hold goes on until there is
  // one.
  void moveTo(const References& references) try {
    if (controller_.flying()) {
      controller_.setReferences(references);
      return;
    }
    FlightPlan hold;
    hold.references = references;
    hold.feed_forward_mass = config_.vehicle.mass;
    hold.gravity = config_.gravity;
    controller_.begin(hold);
  } catch (const std::invalid_argument& e) {
    ROS_ERROR("reference ignored: %s", e.what());
  }

  bool setFlightPlan(SetFlightPlan::Request& request, SetFlightPlan::Response& response) {
    try {
      controller_.begin(fromMsg(request, config_.gravity));
      planned_ = true;
      trajectory_.reset();
      response.success = true;
    } catch (const std::exception& e) {
      response.success = false;
      response.message = e.what();
    }
    return true;
  }

  bool flightRecord(FlightRecord::Request&, FlightRecord::Response& response) {
    response.success = controller_.flying();
    if (!response.success) response.message = "no flight plan has been set";
    toMsg(controller_.record(), response);
    return true;
  }

  NodeConfig config_;
  FlightController controller_;
  SampleClock samples_;
  bool planned_ = false;
  std::optional<ReferenceTrajectory> trajectory_;
  ros::NodeHandle handle_, private_handle_;
  ros::Publisher motor_speed_pub_, input_pub_, feedback_pub_;
  ros::Subscriber odometry_sub_, rotor_speed_sub_, pose_sub_, trajectory_sub_;
  ros::ServiceServer plan_srv_, record_srv_;
};

}  // namespace
}  // namespace quad_control

int main(int argc, char** argv) {
  return quad_support::runProgram("attitude_altitude_controller_node", [&] {
    ros::init(argc, argv, "attitude_altitude_controller");
    const ros::NodeHandle keeps_ros_running;
    quad_control::ControllerNode node(quad_control::readNodeConfig());
    return quad_control::spinUntilInterrupted();
  });
}
