/// Records a vehicle's flight in a bag of its own, as RotorS's bag plugin does.
#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>
#include <rotors_comm/RecordRosbag.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bag_settings.hpp"
#include "quad_sim/simulator.hpp"

namespace rosbag {
class Bag;
}

namespace quad_sim {

/// Writes the true motion, motor speeds, wind and ground contact at instants of its own, the IMU's
/// readings and commands as they come; all of it with simulated times.
///
/// The file is called <name>.bag.active while it grows and takes its name when it is complete: when
/// recording is stopped, when the vehicle is deleted or when the node ends.
class BagRecorder {
 public:
  /// Starts recording unless the settings say to wait for the service.
  /// @throws std::runtime_error if the file cannot be written
  BagRecorder(const BagSettings& settings, const Simulator& simulator, const std::string& vehicle,
              ros::NodeHandle& topics, ros::NodeHandle& services);
  ~BagRecorder();
  BagRecorder(const BagRecorder&) = delete;
  BagRecorder& operator=(const BagRecorder&) = delete;

  std::int64_t nextEvent() const;  ///< step of the next instant; OdometryTopics::kNever if idle
  void atEvent();                  ///< writes if this is such a step
  void setTime() {
    now_ns_ = simulator_.timeNanoseconds();
  }  ///< of what comes by topic from here on

 private:
  using Service = rotors_comm::RecordRosbag;
  bool onRecord(Service::Request& request, Service::Response& response);
  bool start();
  bool stop();
  void listen();
  template <class Message>
  void listenTo(const std::string& topic);  ///< a command: written when it comes
  std::int64_t period() const;              ///< physics steps between instants
  template <class Message>
  void write(const std::string& topic, std::int64_t time_ns, const Message& message);
  void writeMotion(std::int64_t time_ns);
  void writeWind(std::int64_t time_ns);
  void writeContact(std::int64_t time_ns);
  std::string full(const std::string& topic) const { return "/" + vehicle_ + "/" + topic; }

  BagSettings settings_;
  const Simulator& simulator_;
  std::string vehicle_;
  ros::NodeHandle& topics_;
  std::atomic<bool> recording_{false};
  std::atomic<std::int64_t> now_ns_{0};  ///< for callbacks of topics, which do not visit the world
  std::mutex mutex_;                     ///< of the bag
  std::unique_ptr<rosbag::Bag> bag_;
  std::string path_;
  std::vector<ros::Subscriber> subscribers_;  ///< of the services' thread alone
  ros::ServiceServer server_;
};

/// The recorder a model's bag plugin asks for; nullptr if it declares none.
/// @throws quad_support::ConfigError for a tag, or a second bag plugin
std::unique_ptr<BagRecorder> makeBagRecorder(const Simulator& simulator, const std::string& vehicle,
                                             ros::NodeHandle& topics, ros::NodeHandle& services);

}  // namespace quad_sim
