#include <console_bridge/console.h>
#include <fmt/core.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>

#include "quad_support/errors.hpp"
#include "urdf_reader.hpp"

namespace quad_sim {
namespace {

/// Catches what urdfdom would print: its return value only says that something is wrong.
class ComplaintCollector : public console_bridge::OutputHandler {
 public:
  ComplaintCollector() { console_bridge::useOutputHandler(this); }
  ~ComplaintCollector() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_WARN) return;
    all_ += (all_.empty() ? "" : "; ") + text;
  }
  const std::string& text() const { return all_; }

 private:
  std::string all_;
};

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const urdf::Rotation& q = pose.rotation;
  X.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  X.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return X;
}

bool isBaseName(const std::string& name) {
  static const std::string suffix = "/base_link";
  return name == "base_link" ||
         (name.size() > suffix.size() &&
          name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0);
}

LinkRecord toRecord(const urdf::Link& link) {
  LinkRecord record;
  record.name = link.name;
  if (link.inertial) {
    const urdf::Inertial& in = *link.inertial;
    const Eigen::Isometry3d X = toIsometry(in.origin);
    Eigen::Matrix3d inertia;
    inertia << in.ixx, in.ixy, in.ixz, in.ixy, in.iyy, in.iyz, in.ixz, in.iyz, in.izz;
    record.has_inertia = true;
    record.mass = in.mass;
    record.com_L = X.translation();
    record.inertia_L = X.linear() * inertia * X.linear().transpose();
  }
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    if (!collision || !collision->geometry) continue;
    if (collision->geometry->type == urdf::Geometry::CYLINDER) {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(*collision->geometry);
      record.disc_radius = cylinder.radius;
      record.disc_height = cylinder.length;
    }
    if (collision->geometry->type != urdf::Geometry::BOX) continue;
    const urdf::Vector3& dim = static_cast<const urdf::Box&>(*collision->geometry).dim;
    record.boxes.push_back({Eigen::Vector3d(dim.x, dim.y, dim.z), toIsometry(collision->origin)});
  }
  return record;
}

/// Walks the tree from `link`, whose frame in the root is X_RL.
void collect(const urdf::Link& link, const Eigen::Isometry3d& X_RL, int rigid_group, int& groups,
             UrdfTree& tree, std::vector<int>& group_of) {
  LinkRecord record = toRecord(link);
  record.X_BL = X_RL;
  tree.links.push_back(record);
  group_of.push_back(rigid_group);
  for (const urdf::JointSharedPtr& joint : link.child_joints) {
    const bool fixed = joint->type == urdf::Joint::FIXED;
    const bool free = joint->type == urdf::Joint::CONTINUOUS;
    tree.joints.push_back({joint->name, joint->child_link_name,
                           free || joint->type == urdf::Joint::REVOLUTE, free,
                           Eigen::Vector3d(joint->axis.x, joint->axis.y, joint->axis.z)});
    for (const urdf::LinkSharedPtr& child : link.child_links) {
      if (child->name != joint->child_link_name) continue;
      collect(*child, X_RL * toIsometry(joint->parent_to_joint_origin_transform),
              fixed ? rigid_group : ++groups, groups, tree, group_of);
    }
  }
}

}  // namespace

UrdfTree readTree(const std::string& urdf_text, const std::string& file) {
  static std::mutex one_handler;  // console_bridge has one handler for the process
  const std::lock_guard<std::mutex> lock(one_handler);
  ComplaintCollector complaints;
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(urdf_text);
  } catch (const std::exception& e) {  // urdfdom throws on some malformed numbers and logs others
    throw quad_support::ConfigError(fmt::format("{}: not a valid URDF: {}", file, e.what()));
  }
  if (!model || !model->getRoot()) {
    throw quad_support::ConfigError(
        fmt::format("{}: not a valid URDF: {}", file, complaints.text()));
  }
  UrdfTree tree;
  tree.robot = model->getName();
  std::vector<int> group_of;
  int groups = 0;
  collect(*model->getRoot(), Eigen::Isometry3d::Identity(), 0, groups, tree, group_of);

  std::size_t base = 0;
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    if (isBaseName(tree.links[i].name)) base = i;
  }
  tree.base_link = tree.links[base].name;
  const Eigen::Isometry3d X_BR = tree.links[base].X_BL.inverse();
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    tree.links[i].X_BL = X_BR * tree.links[i].X_BL;
    tree.links[i].on_base = group_of[i] == group_of[base];
  }
  return tree;
}

}  // namespace quad_sim
