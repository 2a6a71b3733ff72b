#include "quad_support/interrupt.hpp"

#include <csignal>

#include "quad_support/errors.hpp"

namespace quad_support {
namespace {

volatile std::sig_atomic_t pending_signal = 0;

void onSignal(int signal) {
  if (pending_signal != 0) {  // the loop does not answer: end as the signal would have
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  pending_signal = signal;
}

}  // namespace

void installInterruptHandlers() {
  struct sigaction action = {};
  action.sa_handler = onSignal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void throwIfInterrupted() {
  if (pending_signal != 0) throw Interrupted(pending_signal);
}

}  // namespace quad_support
