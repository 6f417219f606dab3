#include "harness/run/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace mwt {

namespace {

volatile std::sig_atomic_t interrupt_requested = 0;  // the number of the first signal

extern "C" void request_interrupt(int signal_number) {
  if (interrupt_requested == 0) interrupt_requested = signal_number;
}

void change_mask(int how) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGUSR1);
  sigprocmask(how, &signals, nullptr);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  interrupt_requested = 0;
  for (const int signal_number : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal_number, request_interrupt);
  change_mask(SIG_UNBLOCK);
}

InterruptWatch::~InterruptWatch() {
  for (const int signal_number : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal_number, SIG_DFL);
}

bool InterruptWatch::requested() { return interrupt_requested != 0; }

bool InterruptWatch::requested_before_time_limit() { return interrupt_requested == SIGUSR1; }

void hold_time_limit_signal() { change_mask(SIG_BLOCK); }

}  // namespace mwt
