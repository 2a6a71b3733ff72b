// A free body moved without a world step goes where a world step moves it, to the last bit.
#include <gmock/gmock.h>

#include <cstring>

#include "../src/ode_world.hpp"
#include "quad_support/random_stream.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;

/// A body in a world of its own, turned and away from the origin.
class Body {
 public:
  Body() {
    setMass(world_.body, "body", 0.73, Vector3d(0.007, 0.007, 0.012).asDiagonal());
    const dQuaternion q = {0.5, -0.1, 0.7, 0.3};
    dBodySetQuaternion(world_.body, q);
    dBodySetPosition(world_.body, 1.5, -2.25, 5000.125);
  }
  void coastFor(double h, const Vector3d& v, const Vector3d& w) { coast(world_.body, v, w, h); }
  void stepFor(double h, const Vector3d& v, const Vector3d& w) {
    dBodySetLinearVel(world_.body, v.x(), v.y(), v.z());
    dBodySetAngularVel(world_.body, w.x(), w.y(), w.z());
    dWorldStep(world_.world, h);
  }
  bool sameBitsAs(const Body& other) const {
    const dBodyID a = world_.body, b = other.world_.body;
    const auto same = [](const dReal* x, const dReal* y, std::size_t count) {
      return std::memcmp(x, y, count * sizeof(dReal)) == 0;
    };
    return same(dBodyGetPosition(a), dBodyGetPosition(b), 3) &&
           same(dBodyGetQuaternion(a), dBodyGetQuaternion(b), 4) &&
           same(dBodyGetRotation(a), dBodyGetRotation(b), 12);
  }

 private:
  OdeWorld world_;
};

TEST(Coast, MovesAFreeBodyAsAWorldStepDoes) {
  const quad_support::RandomStream random(1, 0, 0);
  for (const double h : {1e-4, 1e-3, 1e-2}) {
    Body coasting, stepping;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const auto draw = [&](std::uint64_t k) { return random.normal(i, k); };
      // Up to a radian a step, and exactly still now and then.
      const double scale = i % 50 == 0 ? 0.0 : 0.3 / h;
      const Vector3d v = 50.0 * Vector3d(draw(0), draw(1), draw(2));
      const Vector3d w = scale * Vector3d(draw(3), draw(4), draw(5));
      coasting.coastFor(h, v, w);
      stepping.stepFor(h, v, w);
      ASSERT_TRUE(coasting.sameBitsAs(stepping)) << "step " << i << " of " << h << " s";
    }
  }
}

}  // namespace
}  // namespace quad_sim
