#include "quad_sim/simulation_config.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "wind_config.hpp"

namespace quad_sim {
namespace {

namespace fs = std::filesystem;
using quad_support::ConfigReader;
using quad_support::Range;

/// Folder of the library or program this code is in.
fs::path ownFolder() {
  Dl_info info{};
  static const char anchor = 0;
  if (dladdr(&anchor, &info) == 0 || !info.dli_fname) return {};
  std::error_code ignored;
  return fs::canonical(info.dli_fname, ignored).parent_path();
}

bool isNamespace(const std::string& text) {
  const auto ok = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '/';
  };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) &&
         text.back() != '/' && text.find("//") == std::string::npos &&
         std::all_of(text.begin(), text.end(), ok);
}

void readVehicle(const ConfigReader& in, SimulationConfig& config) {
  const std::string urdf = in.text("urdf");
  config.urdf = findUrdf(urdf, fs::path(in.resolvePath("x")).parent_path().string());
  if (config.urdf.empty()) {
    in.fail("urdf",
            "is neither beside this file nor among the built or installed models; give a path to a "
            "plain URDF "
            "(build/urdf/hummingbird.urdf is made by `make build`)");
  }
  config.vehicle_namespace = in.text("namespace");
  if (!isNamespace(config.vehicle_namespace)) {
    in.fail("namespace", "must be a ROS name without leading slash: letters, digits, _ and /");
  }
  const bool as_it_stands = in.has("mass") && !in.isSection("mass") && in.text("mass") == "urdf";
  if (!as_it_stands) config.mass = in.number("mass", Range::positive("kg"));
  in.finish();
}

void readSimulation(const ConfigReader& in, SimulationConfig& config) {
  SimulatorOptions& o = config.options;
  o.step = in.number("step", Range{1e-9, 1.0, false, false, "s"});
  const double ns = o.step * 1e9;
  if (std::abs(ns - std::round(ns)) > 1e-6)
    in.fail("step", "must be a whole number of nanoseconds");
  o.gravity = in.number("gravity", Range::closed(0.0, 1000.0, "m/s^2"));
  const bool hinged = in.choice("multibody", {"folded", "hinged"}) == "hinged";
  o.multibody = hinged ? Multibody::kHinged : Multibody::kFolded;
  const bool compat = in.choice("profile", {"default", "rotors_compat"}) == "rotors_compat";
  o.profile = compat ? Profile::kRotorsCompat : Profile::kDefault;
  if (in.has("quirks")) {
    for (const std::string& name : in.choices("quirks", RotorsQuirks::names()))
      o.quirks.byName(name) = true;
  }
  if (in.has("seed"))
    o.seed = static_cast<std::uint64_t>(in.number("seed", Range::closed(0, 4294967295.0, "")));
  o.ground = in.boolean("ground");
  config.wind = readWind(in);
  config.initial_altitude = in.number("initial_altitude", Range::any("m"));
  if (o.ground && config.initial_altitude < 0)
    in.fail("initial_altitude", "must be >= 0 m above the ground");
  in.finish();
}

/// Complains about vehicle.mass where it, and not the URDF, keeps the vehicle from hovering.
void readModel(const ConfigReader& vehicle, SimulationConfig& config) {
  try {
    config.model = loadVehicle(config);
    hoverSpeed(config.model, config.mass ? config.options.gravity : 0.0);
  } catch (const std::invalid_argument& e) {
    hoverSpeed(loadVehicle(config.urdf), 0.0);  // what is wrong with the URDF itself is said here
    vehicle.fail("mass", e.what());
  }
}

}  // namespace

std::string findUrdf(const std::string& name, const std::string& config_folder) {
  std::error_code ignored;
  const fs::path path(name);
  if (path.is_absolute()) return fs::is_regular_file(path, ignored) ? name : "";
  const fs::path beside = fs::path(config_folder) / path;
  if (fs::is_regular_file(beside, ignored)) return beside.string();
  fs::path folder = ownFolder();
  constexpr int kLevels = 5;  // from <build>/devel/lib/<package>/ up to <build>
  for (int i = 0; i < kLevels && !folder.empty(); ++i, folder = folder.parent_path()) {
    for (const fs::path& sub : {fs::path("urdf"), fs::path("share") / "quad_sim" / "urdf"}) {
      if (fs::is_regular_file(folder / sub / path, ignored)) return (folder / sub / path).string();
    }
    if (folder == folder.root_path()) break;
  }
  return "";
}

SimulationConfig readSimulationConfig(const ConfigReader& vehicle, const ConfigReader& simulation) {
  SimulationConfig config;
  readVehicle(vehicle, config);
  readSimulation(simulation, config);
  readModel(vehicle, config);
  return config;
}

SimulationConfig readSimulationConfig(const std::string& yaml_path) {
  const ConfigReader file = ConfigReader::fromFile(yaml_path);
  return readSimulationConfig(file.section("vehicle"), file.section("simulation"));
}

VehicleModel loadVehicle(const SimulationConfig& config) {
  VehicleModel model = loadVehicle(config.urdf, config.mass);
  if (config.wind) putWind(*config.wind, model);
  return model;
}

Simulator makeSimulator(const SimulationConfig& config, const VehicleModel& model) {
  Simulator simulator(model, config.options);
  simulator.setStartState(equilibrium(model, config.options.gravity, config.initial_altitude));
  return simulator;
}

}  // namespace quad_sim
