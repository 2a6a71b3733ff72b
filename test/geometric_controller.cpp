// A geometric tracking controller on SE(3) (Lee, Leok, McClamroch 2010) for RotorS's Hummingbird,
// written against RotorS's topics alone: odometry and command/trajectory in, command/motor_speed
// out. It knows nothing of this simulator; mass, gravity and gains are those RotorS's users have:
// 0.716 kg, 9.81 m/s².
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <Eigen/Dense>
#include <cmath>

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const double kMass = 0.716, kGravity = 9.81;
const double kPosition = 4.0, kVelocity = 2.2;                      // [N/m, N s/m]
const Vector3d kAttitude(0.7, 0.7, 0.035), kRate(0.1, 0.1, 0.025);  // [N m/rad, N m s/rad]
const Vector3d kInertia(0.007, 0.007, 0.012);
const double kArm = 0.17, kForce = 8.54858e-06, kMoment = 0.016;

class Controller {
 public:
  Controller() {
    const double angle[] = {0, M_PI_2, M_PI, -M_PI_2},
                 sign[] = {-1, 1, -1, 1};  // + counter-clockwise
    Eigen::Matrix4d effect;
    for (int i = 0; i < 4; ++i) {
      effect.col(i) << kForce * kArm * std::sin(angle[i]), -kForce * kArm * std::cos(angle[i]),
          -sign[i] * kForce * kMoment, kForce;
    }
    allocation_ = effect.inverse();
    motors_ = n_.advertise<mav_msgs::Actuators>("command/motor_speed", 1);
    trajectory_ = n_.subscribe("command/trajectory", 1, &Controller::onTrajectory, this);
    odometry_ = n_.subscribe("odometry", 1, &Controller::onOdometry, this,
                             ros::TransportHints().tcpNoDelay());
  }

 private:
  void onTrajectory(const trajectory_msgs::MultiDOFJointTrajectory& message) {
    const auto& target = message.points.at(0).transforms.at(0);
    goal_ = Vector3d(target.translation.x, target.translation.y, target.translation.z);
    yaw_ = 2 * std::atan2(target.rotation.z, target.rotation.w);
    active_ = true;
  }

  void onOdometry(const nav_msgs::Odometry& message) {
    mav_msgs::Actuators out;
    out.header.stamp = message.header.stamp;
    out.angular_velocities.assign(4, 0.0);
    if (active_) fly(message, out.angular_velocities);
    motors_.publish(out);
  }

  void fly(const nav_msgs::Odometry& message, std::vector<double>& speeds) const {
    const auto& p = message.pose.pose.position;
    const auto& q = message.pose.pose.orientation;
    const auto& v = message.twist.twist.linear;
    const auto& w = message.twist.twist.angular;
    const Matrix3d R = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    const Vector3d rate(w.x, w.y, w.z);
    const Vector3d velocity = R * Vector3d(v.x, v.y, v.z);  // the twist is in body axes
    const Vector3d force = kPosition * (goal_ - Vector3d(p.x, p.y, p.z)) - kVelocity * velocity +
                           Vector3d(0, 0, kMass * kGravity);
    const Vector3d b3 = force.normalized();
    const Vector3d b2 = b3.cross(Vector3d(std::cos(yaw_), std::sin(yaw_), 0)).normalized();
    Matrix3d wanted;
    wanted << b2.cross(b3), b2, b3;
    const Matrix3d E = 0.5 * (wanted.transpose() * R - R.transpose() * wanted);
    const Vector3d torque = -kAttitude.cwiseProduct(Vector3d(E(2, 1), E(0, 2), E(1, 0))) -
                            kRate.cwiseProduct(rate) + rate.cross(kInertia.cwiseProduct(rate));
    const Eigen::Vector4d squares =
        allocation_ * Eigen::Vector4d(torque.x(), torque.y(), torque.z(), force.dot(R.col(2)));
    for (int i = 0; i < 4; ++i)
      speeds[static_cast<std::size_t>(i)] = std::sqrt(std::max(0.0, squares[i]));
  }

  ros::NodeHandle n_;
  Eigen::Matrix4d allocation_;
  Vector3d goal_ = Vector3d::Zero();
  double yaw_ = 0;
  bool active_ = false;
  ros::Publisher motors_;
  ros::Subscriber trajectory_, odometry_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "geometric_controller");
  const Controller controller;
  ros::spin();
  return 0;
}
