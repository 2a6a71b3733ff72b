// A force plugin in a library of its own: a constant push along the body's y through the centre of
// mass.
#include "quad_sim/plugin.hpp"

namespace {

class PushPlugin : public quad_sim::Plugin {
 public:
  PushPlugin(const quad_sim::VehicleModel& model, const quad_sim::WorldSettings&)
      : force_(model.plugins.back().number("force")) {}
  void step(const quad_sim::StepInput&, quad_sim::StepLoad& load) override {
    load.force_B.y() += force_;
  }
  void restore(const quad_sim::VehicleState&) override {}
  void save(quad_sim::VehicleState&) const override {}

 private:
  double force_;  ///< [N]
};

}  // namespace

QUAD_SIM_REGISTER_PLUGIN(PushPlugin)
