// Waiting for a command: how long at most, and what ends it.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "command_inbox.hpp"

namespace quad_sim {
namespace {

TEST(CommandInbox, AHugeTimeoutWaitsForTheCommand) {
  // Added to the clock as they are, these overflow its nanoseconds, and the wait is over before it
  // begins.
  for (const double timeout : {1e10, 1e300, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(timeout);
    CommandInbox inbox;
    std::thread controller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(
          20));  // so that the wait has begun; the answer is the same if not
      inbox.put(7, {{1, 2, 3, 4}, ""});
    });
    const auto command = inbox.waitFor(7, timeout);
    controller.join();
    ASSERT_TRUE(command);
    EXPECT_EQ(command->rotor_speed, (std::vector<double>{1, 2, 3, 4}));
  }
}

TEST(CommandInbox, StopEndsAHugeTimeout) {
  CommandInbox inbox;
  std::thread stopper([&] { inbox.stop(); });
  EXPECT_FALSE(inbox.waitFor(7, 1e300));
  stopper.join();
}

TEST(CommandInbox, WithoutTimeItOnlyLooks) {
  CommandInbox inbox;
  for (const double timeout : {0.0, -1.0, std::nan("")}) EXPECT_FALSE(inbox.waitFor(7, timeout));
  inbox.put(7, {{1}, ""});
  for (const double timeout : {0.0, -1.0, std::nan("")}) EXPECT_TRUE(inbox.waitFor(7, timeout));
}

}  // namespace
}  // namespace quad_sim
