// A plugin of one's own: the air's resistance to the airframe, F = -(rho/2) c_d A |v| v at a point
// of the body, which RotorS leaves out.
//
//   <gazebo>
//     <plugin name="drag" filename="libbody_drag.so">
//       <dragArea>0.02</dragArea>           <!-- c_d A [m^2] -->
//       <airDensity>1.225</airDensity>      <!-- [kg/m^3] -->
//       <xyzOffset>0 0 0</xyzOffset>        <!-- [m], from base_link's origin -->
//     </plugin>
//   </gazebo>
#include <Eigen/Geometry>
#include <quad_sim/plugin.hpp>

namespace {

class BodyDrag : public quad_sim::Plugin {
 public:
  BodyDrag(const quad_sim::VehicleModel& model, const quad_sim::WorldSettings&) {
    for (const quad_sim::PluginDeclaration& p : model.plugins) {
      if (p.filename.find("body_drag") == std::string::npos) continue;
      factor_ = 0.5 * p.number("airDensity", 1.225) * p.number("dragArea");
      if (factor_ < 0) p.fail("dragArea", "and airDensity must be >= 0");
      point_C_ = p.vector("xyzOffset", Eigen::Vector3d::Zero()) - model.com_B;
    }
  }

  void step(const quad_sim::StepInput& input, quad_sim::StepLoad& load) override {
    const Eigen::Vector3d v = input.v_WC_B + input.w_WB_B.cross(point_C_);
    const Eigen::Vector3d force = -factor_ * v.norm() * v;
    load.force_B += force;
    load.torque_B += point_C_.cross(force);
  }

  void restore(const quad_sim::VehicleState&) override {}  // it remembers nothing
  void save(quad_sim::VehicleState&) const override {}

 private:
  double factor_ = 0;        ///< (rho/2) c_d A [kg/m]
  Eigen::Vector3d point_C_;  ///< where it acts, from the centre of mass [m]
};

}  // namespace

QUAD_SIM_REGISTER_PLUGIN(BodyDrag)
