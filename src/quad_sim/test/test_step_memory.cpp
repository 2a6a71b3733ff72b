// A physics step allocates nothing.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstdlib>
#include <new>

#include "allocation_counter.hpp"
#include "hummingbird.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {
namespace {

using quad_support::testing::AllocationCounter;

TEST(AllocationCounter, SeesEveryWayToTheHeap) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  const auto counted = [](auto allocate) {
    AllocationCounter counter;
    void* volatile p = allocate();  // volatile: the compiler may not leave the pair out
    const long count = counter.count();
    std::free(p);
    return count;
  };
  EXPECT_EQ(counted([] { return static_cast<void*>(nullptr); }), 0);
  EXPECT_EQ(counted([] { return std::malloc(8); }), 1);
  EXPECT_EQ(counted([] { return std::calloc(2, 8); }), 1);
  EXPECT_EQ(counted([] { return std::realloc(nullptr, 8); }), 1);
  EXPECT_EQ(counted([] { return std::aligned_alloc(64, 64); }), 1);
  EXPECT_EQ(counted([] {
              void* p = nullptr;
              return posix_memalign(&p, 64, 64) == 0 ? p : nullptr;
            }),
            1);
  AllocationCounter counter;
  ::operator delete(::operator new(8));
  ::operator delete(::operator new(64, std::align_val_t(64)), std::align_val_t(64));
  EXPECT_EQ(counter.count(), 2);
  const Eigen::VectorXd vector = Eigen::VectorXd::Zero(3);
  EXPECT_EQ(counter.count(), 3) << vector;
  dFree(dAlloc(8), 8);  // ODE's own way, from within its library
  EXPECT_GE(counter.count(), 4);
}

/// Allocations of 100 intervals of 100 steps, one command and one measurement each, after `warm_up`
/// steps.
long allocationsInFlight(double altitude, double speed, int warm_up) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  VehicleState start = equilibrium(m, 9.8, altitude);
  start.rotor_speed.assign(4, speed);
  s.setStartState(start);
  Measurement measurement = s.measure();
  std::vector<double> command = start.rotor_speed;
  command[0] += 3;
  s.advance(warm_up);
  AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    s.setCommand(command);
    s.advance(100);
    s.measure(measurement);
  }
  return counter.count();
}

TEST(Simulator, AStepAllocatesNothing) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  // From high enough not to touch the ground in these 10 s: the first touch lets ODE reserve memory
  // for contacts.
  EXPECT_EQ(allocationsInFlight(5000, hoverSpeed(hummingbird(), 9.8), 1), 0);
}

TEST(Simulator, AStepOnTheGroundAllocatesNothing) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  // After a second the vehicle lies; ODE keeps the memory it reserved for the contacts before.
  EXPECT_EQ(allocationsInFlight(0.06, 0, 1000), 0);
}

}  // namespace
}  // namespace quad_sim
