#include "bag_recorder.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <mav_msgs/Actuators.h>
#include <mav_msgs/AttitudeThrust.h>
#include <mav_msgs/RateThrust.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Imu.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "model_state.hpp"
#include "odometry_topics.hpp"
#include "quad_sim_ros/conversions.hpp"
#include "quad_support/errors.hpp"
#include "vehicle_topics.hpp"

namespace quad_sim {
namespace {

constexpr int kBagQueue = 100;

}  // namespace

BagRecorder::BagRecorder(const BagSettings& settings, const Simulator& simulator,
                         const std::string& vehicle, ros::NodeHandle& topics,
                         ros::NodeHandle& services)
    : settings_(settings), simulator_(simulator), vehicle_(vehicle), topics_(topics) {
  if (!settings_.wait && !start()) {
    throw quad_support::EnvironmentError(vehicle_ + ": the bag " + settings_.file +
                                         " cannot be written; see <bagFileName>");
  }
  server_ = services.advertiseService(full(settings_.service), &BagRecorder::onRecord, this);
}

BagRecorder::~BagRecorder() {
  server_.shutdown();
  stop();
}

bool BagRecorder::onRecord(Service::Request& request, Service::Response& response) {
  response.success = request.record ? start() : stop();
  return true;  // RotorS fails the call instead, which tells a caller nothing
}

bool BagRecorder::start() {
  if (recording_) {
    ROS_WARN("/%s: recording already", vehicle_.c_str());
    return false;
  }
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  const std::string path =
      bagName(settings_.file, std::chrono::duration_cast<std::chrono::seconds>(since_1970).count());
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    bag_ = std::make_unique<rosbag::Bag>();
    try {
      bag_->open(path + ".active", rosbag::bagmode::Write);
    } catch (const rosbag::BagException& e) {
      bag_.reset();
      ROS_ERROR("/%s: %s.active cannot be written: %s", vehicle_.c_str(), path.c_str(), e.what());
      return false;
    }
    path_ = path;
  }
  recording_ = true;
  listen();
  ROS_INFO("/%s: recording %s", vehicle_.c_str(), path.c_str());
  return true;
}

bool BagRecorder::stop() {
  recording_ = false;
  subscribers_.clear();  // without the lock, for this waits for callbacks, and they for the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!bag_) return false;
  try {
    bag_->close();
    std::filesystem::rename(path_ + ".active", path_);
    ROS_INFO("/%s: recorded %s", vehicle_.c_str(), path_.c_str());
  } catch (const std::exception& e) {
    ROS_ERROR("/%s: %s stays incomplete: %s", vehicle_.c_str(), path_.c_str(), e.what());
    bag_.reset();
    return false;
  }
  bag_.reset();
  return true;
}

template <class Message>
void BagRecorder::write(const std::string& topic, std::int64_t time_ns, const Message& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!bag_ || !recording_) return;
  try {
    bag_->write(full(topic), toStamp(time_ns), message);
  } catch (const rosbag::BagException& e) {
    ROS_ERROR("/%s: recording %s ends: %s", vehicle_.c_str(), path_.c_str(), e.what());
    recording_ = false;
  }
}

template <class Message>
void BagRecorder::listenTo(const std::string& topic) {
  const boost::function<void(const typename Message::ConstPtr&)> take =
      [this, topic](const typename Message::ConstPtr& message) { write(topic, now_ns_, *message); };
  subscribers_.push_back(topics_.subscribe<Message>(full(topic), kBagQueue, take));
}

void BagRecorder::listen() {
  const boost::function<void(const sensor_msgs::Imu::ConstPtr&)> take =
      [this](const sensor_msgs::Imu::ConstPtr& message) {
        write(settings_.imu, toNanoseconds(message->header.stamp), *message);
      };
  subscribers_.push_back(topics_.subscribe<sensor_msgs::Imu>(full(settings_.imu), kBagQueue, take));
  listenTo<trajectory_msgs::MultiDOFJointTrajectory>(settings_.trajectory);
  listenTo<geometry_msgs::PoseStamped>(settings_.command_pose);
  listenTo<mav_msgs::AttitudeThrust>(settings_.attitude_thrust);
  listenTo<mav_msgs::Actuators>(settings_.command_motor_speed);
  listenTo<mav_msgs::RateThrust>(settings_.rate_thrust);
}

std::int64_t BagRecorder::period() const {
  return std::max<std::int64_t>(1, settings_.cycle_us * 1000 / simulator_.stepNanoseconds());
}

std::int64_t BagRecorder::nextEvent() const {
  if (!recording_) return OdometryTopics::kNever;
  return (simulator_.stepCount() / period() + 1) * period();
}

void BagRecorder::atEvent() {
  setTime();
  if (!recording_ || simulator_.stepCount() % period() != 0) return;
  const std::int64_t time_ns = simulator_.timeNanoseconds();
  writeContact(time_ns);
  writeMotion(time_ns);
  writeWind(time_ns);
}

void BagRecorder::writeMotion(std::int64_t time_ns) {
  const VehicleState state = simulator_.state();
  const ModelState link = linkState(state, settings_.link);
  geometry_msgs::PoseStamped pose;
  pose.header.stamp = toStamp(time_ns);
  pose.header.frame_id = settings_.frame;
  pose.pose = poseMsg(link);
  write(settings_.pose, time_ns, pose);
  geometry_msgs::TwistStamped twist;
  twist.header = pose.header;
  twist.twist = twistMsg(link);
  write(settings_.twist, time_ns, twist);
  write(settings_.motor_speed, time_ns, toMsg(state.rotor_speed, simulator_.model(), time_ns, ""));
}

void BagRecorder::writeWind(std::int64_t time_ns) {
  write(settings_.wind_speed, time_ns, windMessage(simulator_));
  if (!windPlugin(simulator_.model())) return;
  write(settings_.external_force, time_ns, forceMessage(simulator_, settings_.force_frame));
}

void BagRecorder::writeContact(std::int64_t time_ns) {
  const Wrench load = simulator_.groundLoad();
  constexpr double kNothing = 1e-10;  // [N], RotorS's
  if (!(load.force.norm() > kNothing)) return;
  geometry_msgs::WrenchStamped message;
  message.header.stamp = toStamp(time_ns);
  message.header.frame_id = vehicle_ + "::" + simulator_.model().base_link + "--ground_plane::link";
  message.wrench = wrenchMsg(load);
  write(settings_.wrench, time_ns, message);
}

std::unique_ptr<BagRecorder> makeBagRecorder(const Simulator& simulator, const std::string& vehicle,
                                             ros::NodeHandle& topics, ros::NodeHandle& services) {
  const PluginDeclaration* found = nullptr;
  for (const PluginDeclaration& p : simulator.model().plugins) {
    if (p.filename != "librotors_gazebo_bag_plugin.so") continue;
    if (found) p.fail("bagFileName", "is of a second bag plugin; a vehicle records one bag");
    found = &p;
  }
  if (!found) return nullptr;
  BagSettings settings(*found, simulator.model());
  settings.frame = frameOf(*found, settings.frame, vehicle);
  settings.force_frame = forceFrame(simulator.model(), vehicle);
  return std::make_unique<BagRecorder>(settings, simulator, vehicle, topics, services);
}

}  // namespace quad_sim
