#include "bag_settings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>

#include "quad_sim/odometry_sensor.hpp"

namespace quad_sim {
namespace {

namespace fs = std::filesystem;

const LinkModel& recordedLink(const PluginDeclaration& p, const VehicleModel& model) {
  const std::string& name = p.text("linkName");
  const auto it = std::find_if(model.links.begin(), model.links.end(),
                               [&](const LinkModel& link) { return link.name == name; });
  if (it == model.links.end()) p.fail("linkName", "names no link of the robot");
  if (!it->on_base) p.fail("linkName", "must be a link fixed to " + model.base_link);
  return *it;
}

bool isTrue(const PluginDeclaration& p, const std::string& tag) {
  const std::string value = p.text(tag, "false");
  if (value == "true" || value == "1") return true;
  if (value != "false" && value != "0") p.fail(tag, "must be true or false");
  return false;
}

}  // namespace

BagSettings::BagSettings(const PluginDeclaration& p, const VehicleModel& model)
    : file(p.text("bagFileName", "simulator.bag")),
      link(recordedLink(p, model)),
      frame(p.text("frameId", "ground_truth_pose")),
      service(p.text("recordingServiceName", "record_rosbag")),
      wait(isTrue(p, "waitToRecordBag")),
      cycle_us(sensorCycle(p, 1e-6)),
      pose(p.text("poseTopic", "ground_truth/pose")),
      twist(p.text("twistTopic", "ground_truth/twist")),
      motor_speed(p.text("motorTopic", "motor_speed")),
      wrench(p.text("wrenchesTopic", "wrench")),
      imu(p.text("imuTopic", "imu")),
      external_force(p.text("externalForceTopic", p.text("windTopic", "external_force"))),
      wind_speed(p.text("windSpeedTopic", "wind_speed")),
      trajectory(p.text("waypointTopic", "command/trajectory")),
      command_pose(p.text("commandPoseTopic", "command/pose")),
      attitude_thrust(p.text("commandAttitudeThrustTopic", "command/attitude_thrust")),
      command_motor_speed(p.text("commandMotorSpeedTopic", "command/motor_speed")),
      rate_thrust(p.text("commandRateThrustTopic", "command/rate_thrust")) {
  if (file.empty()) p.fail("bagFileName", "must not be empty");
}

std::string bagName(const std::string& file, std::int64_t unix_seconds) {
  const std::time_t seconds = unix_seconds;
  std::tm local{};
  localtime_r(&seconds, &local);
  std::array<char, 80> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%d-%H-%M-%S", &local);
  const auto suffix = file.rfind(".bag");
  const std::string stem = fmt::format("{}_{}", file.substr(0, suffix), date.data());
  std::string name = stem + ".bag";
  std::error_code ignored;
  for (int i = 2; fs::exists(name, ignored) || fs::exists(name + ".active", ignored); ++i) {
    name = fmt::format("{}_{}.bag", stem, i);
  }
  return name;
}

}  // namespace quad_sim
