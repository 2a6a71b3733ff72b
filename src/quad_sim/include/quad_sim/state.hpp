/// What is known about a flying vehicle at one instant. Frames: W inertial, z up; B the vehicle's
/// base_link, x forward, y left, z up. Names: p_WB is B's origin in W, v_WB its velocity in world
/// axes, _B says "expressed in B".
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace quad_sim {

/// The whole state of the plant. Position and velocity are those of base_link's ORIGIN, not of the
/// centre of mass.
struct VehicleState {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond q_WB =
      Eigen::Quaterniond::Identity();                ///< B to W; normalised where it is taken in
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();    ///< [m/s], world axes
  Eigen::Vector3d w_WB_B = Eigen::Vector3d::Zero();  ///< [rad/s], body axes
  std::vector<double>
      rotor_speed;  ///< [rad/s], >= 0 (but see RotorsQuirks::unchecked_commands), by motor number
};

/// A force and a torque, world axes.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< about the vehicle's centre of mass [N m]
};

/// Place and motion of a rotor's own body, world axes.
struct RotorState {
  Eigen::Vector3d p_WR;     ///< [m]
  Eigen::Quaterniond q_WR;  ///< its z is the rotor's axis
  Eigen::Vector3d v_WR;     ///< [m/s]
  Eigen::Vector3d w_WR;     ///< [rad/s]
};

/// What the ideal odometry sensor delivers: the pose in W and the twist in BODY axes, like
/// nav_msgs/Odometry.
struct Odometry {
  std::int64_t time_ns = 0;                        ///< simulated time [ns]
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WB_B = Eigen::Vector3d::Zero();  ///< [m/s], body axes
  Eigen::Vector3d w_WB_B = Eigen::Vector3d::Zero();  ///< [rad/s], body axes
};

/// Odometry and rotor speeds of the same instant.
struct Measurement {
  Odometry odometry;
  std::vector<double> rotor_speed;  ///< [rad/s], unsigned, by motor number
  std::optional<std::int64_t>
      ground_contact_ns;  ///< when the vehicle first touched the ground, if it has
};

}  // namespace quad_sim
