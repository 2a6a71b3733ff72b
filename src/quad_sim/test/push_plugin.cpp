// A force plugin in a library of its own: a constant push along the body's y through the centre of mass.
#include "quad_sim/plugin.hpp"

namespace {

class PushPlugin : public quad_sim::Plugin {
 public:
  explicit PushPlugin(double force) : force_(force) {}
  void step(const quad_sim::StepInput&, quad_sim::StepLoad& load) override { load.force_B.y() += force_; }
  void restore(const quad_sim::VehicleState&) override {}
  void save(quad_sim::VehicleState&) const override {}

 private:
  double force_;  ///< [N]
};

}  // namespace

extern "C" quad_sim::Plugin* quad_sim_make_plugin(const quad_sim::VehicleModel& model, double) {
  return new PushPlugin(model.plugins.back().number("force"));
}
