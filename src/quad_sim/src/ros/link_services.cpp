#include "link_services.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

LinkServices::LinkServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = LinkServices;
  servers_ = {
      handle.advertiseService("/gazebo/get_link_state", &Self::onGet, this),
      handle.advertiseService("/gazebo/set_link_state", &Self::onSet, this),
      handle.advertiseService("/gazebo/apply_body_wrench", &Self::onApply, this),
      handle.advertiseService("/gazebo/clear_body_wrenches", &Self::onClear, this),
  };
  constexpr int kQueueLength = 10;
  link_state_sub_ =
      handle.subscribe("/gazebo/set_link_state", kQueueLength, &Self::onLinkState, this);
}

namespace {

std::string noLink(const std::string& name) {
  return fmt::format(
      "no link '{}', or it is in several models; give model::link, such as "
      "hummingbird::hummingbird/base_link",
      name);
}

/// The motion of a vehicle one of whose links, fixed to base_link, moves as `link` does.
ModelState vehicleOf(const ModelState& link, const Eigen::Isometry3d& X_BL) {
  const Eigen::Quaterniond q = link.attitude * Eigen::Quaterniond(X_BL.linear()).conjugate();
  const Eigen::Vector3d arm = q * X_BL.translation();
  return {link.position - arm, q, link.velocity - link.rate.cross(arm), link.rate};
}

Eigen::Vector3d toEigen(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string LinkServices::get(const gazebo_msgs::GetLinkState::Request& request,
                              gazebo_msgs::LinkState& out) {
  const WorldGate::Visit visit(world_.gate());
  const LinkOf found = world_.findLink(request.link_name);
  const LinkOf frame = world_.findLink(request.reference_frame);
  if (!found.link) return noLink(request.link_name);
  if (!frame.link && !isWorld(request.reference_frame)) return noLink(request.reference_frame);
  ModelState state = linkState(*found.vehicle, *found.link);
  if (frame.link) state = relativeTo(linkState(*frame.vehicle, *frame.link), state);
  out.link_name = request.link_name;
  out.reference_frame = request.reference_frame;
  out.pose = poseMsg(state);
  out.twist = twistMsg(state);
  return "";
}

bool LinkServices::onGet(gazebo_msgs::GetLinkState::Request& request,
                         gazebo_msgs::GetLinkState::Response& response) {
  const std::string problem = get(request, response.link_state);
  response.success = problem.empty();
  response.status_message = "GetLinkState: " + (problem.empty() ? "got state" : problem);
  return true;
}

std::string LinkServices::set(const gazebo_msgs::LinkState& wanted) {
  const WorldGate::Visit visit(world_.gate());
  const LinkOf found = world_.findLink(wanted.link_name);
  const LinkOf frame = world_.findLink(wanted.reference_frame);
  if (!found.link) return noLink(wanted.link_name);
  if (!frame.link && !isWorld(wanted.reference_frame)) return noLink(wanted.reference_frame);
  if (!found.link->on_base) {
    return "only a link fixed to base_link can be set, and takes the vehicle along";
  }
  Simulator& simulator = found.vehicle->simulator;
  try {
    ModelState given = modelState(wanted.pose, wanted.twist);
    if (frame.link) given = fromFrame(linkState(*frame.vehicle, *frame.link), given);
    simulator.setState(moved(simulator.state(), vehicleOf(given, found.link->X_BL)));
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  world_.publish();
  return "";
}

bool LinkServices::onSet(gazebo_msgs::SetLinkState::Request& request,
                         gazebo_msgs::SetLinkState::Response& response) {
  const std::string problem = set(request.link_state);
  response.success = problem.empty();
  response.status_message = "SetLinkState: " + (problem.empty() ? "success" : problem);
  return true;
}

void LinkServices::onLinkState(const gazebo_msgs::LinkState& wanted) {
  const std::string problem = set(wanted);
  if (!problem.empty()) ROS_ERROR("/gazebo/set_link_state: %s", problem.c_str());
}

std::string LinkServices::apply(const gazebo_msgs::ApplyBodyWrench::Request& request) {
  const WorldGate::Visit visit(world_.gate());
  const LinkOf found = world_.findLink(request.body_name);
  const LinkOf frame = world_.findLink(request.reference_frame);
  if (!found.link) return noLink(request.body_name);
  if (!frame.link && !isWorld(request.reference_frame)) return noLink(request.reference_frame);
  if (!found.link->on_base) return "only a link fixed to base_link takes a wrench";
  const Simulator& simulator = found.vehicle->simulator;
  const VehicleState state = simulator.state();
  const auto& p = request.reference_point;
  Push push{{toEigen(request.wrench.force), toEigen(request.wrench.torque)}, 0, Push::kForEver};
  Eigen::Vector3d arm(p.x, p.y, p.z);
  if (frame.link) {
    const ModelState at = linkState(*frame.vehicle, *frame.link);
    push.wrench.force = at.attitude * push.wrench.force;
    push.wrench.torque = at.attitude * push.wrench.torque;
    arm = at.position + at.attitude * arm - state.p_WB - state.q_WB * simulator.model().com_B;
  }
  push.wrench.torque += arm.cross(push.wrench.force);
  push.start_ns = std::max(toNanoseconds(request.start_time), world_.timeNanoseconds());
  const std::int64_t duration = request.duration.toNSec();
  if (duration >= 0) push.end_ns = std::min(push.start_ns + duration, Push::kForEver);
  try {
    found.vehicle->pushes.add(push);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

bool LinkServices::onApply(gazebo_msgs::ApplyBodyWrench::Request& request,
                           gazebo_msgs::ApplyBodyWrench::Response& response) {
  const std::string problem = apply(request);
  response.success = problem.empty();
  response.status_message = "ApplyBodyWrench: " + (problem.empty() ? "applied" : problem);
  return true;
}

bool LinkServices::onClear(gazebo_msgs::BodyRequest::Request& request,
                           gazebo_msgs::BodyRequest::Response&) {
  const WorldGate::Visit visit(world_.gate());
  const LinkOf found = world_.findLink(request.body_name);
  if (found.vehicle) {
    found.vehicle->pushes.clear();
  } else {
    ROS_ERROR("/gazebo/clear_body_wrenches: %s", noLink(request.body_name).c_str());
  }
  return found.vehicle != nullptr;
}

}  // namespace quad_sim
