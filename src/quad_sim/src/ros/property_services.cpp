#include "property_services.hpp"

#include <algorithm>

namespace quad_sim {

PropertyServices::PropertyServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = PropertyServices;
  servers_ = {
      handle.advertiseService("/gazebo/get_model_properties", &Self::onModel, this),
      handle.advertiseService("/gazebo/get_link_properties", &Self::onLink, this),
      handle.advertiseService("/gazebo/get_joint_properties", &Self::onJoint, this),
  };
}

bool PropertyServices::onModel(gazebo_msgs::GetModelProperties::Request& request,
                               gazebo_msgs::GetModelProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  const Vehicle* const vehicle = world_.find(request.model_name);
  if (!vehicle) {
    response.status_message = "GetModelProperties: " + world_.nobody(request.model_name);
    return true;
  }
  const VehicleModel& model = vehicle->simulator.model();
  response.canonical_body_name = model.base_link;
  for (const LinkModel* link : bodies(model)) {
    response.body_names.push_back(link->name);
    if (link->name != model.base_link) response.joint_names.push_back(link->joint);
  }
  response.success = true;
  response.status_message = "GetModelProperties: got properties";
  return true;
}

bool PropertyServices::onLink(gazebo_msgs::GetLinkProperties::Request& request,
                              gazebo_msgs::GetLinkProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  const LinkModel* const link = world_.findLink(request.link_name).link;
  if (!link) {
    response.status_message = "GetLinkProperties: no link '" + request.link_name + "'";
    return true;
  }
  response.com = poseMsg({link->com_L, Eigen::Quaterniond::Identity(), {}, {}});
  response.gravity_mode = true;
  response.mass = link->mass;
  const Eigen::Matrix3d& inertia = link->inertia_L;
  response.ixx = inertia(0, 0);
  response.ixy = inertia(0, 1);
  response.ixz = inertia(0, 2);
  response.iyy = inertia(1, 1);
  response.iyz = inertia(1, 2);
  response.izz = inertia(2, 2);
  response.success = true;
  response.status_message = "GetLinkProperties: got properties";
  return true;
}

bool PropertyServices::onJoint(gazebo_msgs::GetJointProperties::Request& request,
                               gazebo_msgs::GetJointProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  for (const auto& vehicle : world_.vehicles()) {
    for (const RotorModel& rotor : vehicle->simulator.model().rotors) {
      if (rotor.joint != request.joint_name) continue;
      const JointMotion motion = jointMotion(*vehicle, rotor);
      response.type = gazebo_msgs::GetJointProperties::Response::CONTINUOUS;
      response.damping = {0.0};
      response.position = {motion.angle};
      response.rate = {motion.speed};
      response.success = true;
      response.status_message = "GetJointProperties: got properties";
      return true;
    }
  }
  response.status_message = "GetJointProperties: no rotor's joint '" + request.joint_name + "'";
  return true;
}

}  // namespace quad_sim
