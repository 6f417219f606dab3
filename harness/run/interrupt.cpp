#include "harness/run/interrupt.h"

#include <csignal>

namespace mwt {

namespace {

volatile std::sig_atomic_t interrupt_requested = 0;

extern "C" void request_interrupt(int) { interrupt_requested = 1; }

}  // namespace

InterruptWatch::InterruptWatch() {
  interrupt_requested = 0;
  std::signal(SIGINT, request_interrupt);
  std::signal(SIGTERM, request_interrupt);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptWatch::requested() { return interrupt_requested != 0; }

}  // namespace mwt
