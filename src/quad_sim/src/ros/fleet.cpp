#include "fleet.hpp"

#include <fmt/core.h>

#include <cmath>

#include "quad_sim/simulation_config.hpp"
#include "quad_support/config_reader.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using XmlRpc::XmlRpcValue;

/// One entry of ~vehicles, with messages that name it.
class Entry {
 public:
  Entry(const std::string& name, XmlRpcValue& value) : name_(name), value_(value) {
    if (value.getType() != XmlRpcValue::TypeStruct)
      fail("", "must be a map, such as {x: 1, y: 0, z: 1}");
    for (auto& item : value) {
      const bool known = std::string(" urdf mass x y z yaw hover ").find(" " + item.first + " ") !=
                         std::string::npos;
      if (!known) fail(item.first, "is no key; there are urdf, mass, x, y, z, yaw, hover");
    }
  }
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const {
    throw quad_support::ConfigError(
        fmt::format("parameter ~vehicles/{}{}{}: {}", name_, key.empty() ? "" : "/", key, problem));
  }
  bool has(const std::string& key) { return value_.hasMember(key); }
  double number(const std::string& key, double fallback) {
    if (!has(key)) return fallback;
    XmlRpcValue& v = value_[key];
    double x = NAN;
    if (v.getType() == XmlRpcValue::TypeDouble) x = static_cast<double>(v);
    if (v.getType() == XmlRpcValue::TypeInt) x = static_cast<int>(v);
    if (!std::isfinite(x)) fail(key, "must be a finite number");
    return x;
  }
  std::string text(const std::string& key, const std::string& fallback) {
    if (!has(key)) return fallback;
    if (value_[key].getType() != XmlRpcValue::TypeString) fail(key, "must be text");
    return static_cast<std::string>(value_[key]);
  }
  bool boolean(const std::string& key, bool fallback) {
    if (!has(key)) return fallback;
    if (value_[key].getType() != XmlRpcValue::TypeBoolean) fail(key, "must be true or false");
    return static_cast<bool>(value_[key]);
  }

 private:
  std::string name_;
  XmlRpcValue& value_;
};

VehicleSpec specOf(const std::string& name, XmlRpcValue& value, const SimulationConfig& usual,
                   const std::string& folder) {
  Entry entry(name, value);
  SimulationConfig config = usual;
  if (entry.has("urdf")) {
    config.urdf = findUrdf(entry.text("urdf", ""), folder);
    config.mass.reset();
    if (config.urdf.empty())
      entry.fail("urdf", "is no file beside the configuration or among the built models");
  }
  if (entry.has("mass")) config.mass = entry.number("mass", 0);
  const double z = entry.number("z", usual.initial_altitude), yaw = entry.number("yaw", 0);
  if (usual.options.ground && z < 0) entry.fail("z", "must be >= 0 m above the ground");
  VehicleSpec spec{name, loadVehicle(config), config.options, {}};
  spec.start = equilibrium(spec.model, usual.options.gravity, z);
  spec.start.p_WB.head<2>() << entry.number("x", 0), entry.number("y", 0);
  spec.start.q_WB = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  if (!entry.boolean("hover", true))
    spec.start.rotor_speed.assign(spec.start.rotor_speed.size(), 0.0);
  return spec;
}

std::uint64_t readSeed(const ros::NodeHandle& own, std::uint64_t fallback) {
  XmlRpcValue value;
  if (!own.getParam("seed", value)) return fallback;
  const int seed = value.getType() == XmlRpcValue::TypeInt ? static_cast<int>(value) : -1;
  if (seed < 0)
    throw quad_support::ConfigError("parameter ~seed must be a whole number in 0..2147483647");
  return static_cast<std::uint64_t>(seed);
}

}  // namespace

std::vector<VehicleSpec> readFleet(const ros::NodeHandle& own, const std::string& config_path) {
  SimulationConfig usual = readSimulationConfig(config_path);
  usual.options.seed = readSeed(own, usual.options.seed);
  XmlRpcValue vehicles;
  if (!own.getParam("vehicles", vehicles)) {
    const VehicleState start =
        equilibrium(usual.model, usual.options.gravity, usual.initial_altitude);
    return {{usual.vehicle_namespace, usual.model, usual.options, start}};
  }
  if (vehicles.getType() != XmlRpcValue::TypeStruct || vehicles.size() == 0) {
    throw quad_support::ConfigError(
        "parameter ~vehicles must be a map from namespace to {x, y, z, yaw, urdf, mass, hover}");
  }
  const std::string folder = config_path.substr(0, config_path.rfind('/') + 1);
  std::vector<VehicleSpec> fleet;
  for (auto& item : vehicles)
    fleet.push_back(specOf(item.first, item.second, usual, folder));  // a std::map: by name
  return fleet;
}

}  // namespace quad_sim
