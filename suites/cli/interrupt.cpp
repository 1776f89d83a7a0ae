#include "suites/cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <string_view>

namespace sb {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> g_interrupted = false;
volatile sig_atomic_t g_signal = 0;
static_assert(std::atomic<bool>::is_always_lock_free, "set in a signal handler");

void onSignal(int signal) {
  if (g_interrupted.exchange(true)) _exit(128 + signal);
  g_signal = signal;
  static constexpr std::string_view kText =
      "\nbench: stopping after the block under way; once more stops at once\n";
  // A terminal that went away takes nothing, and that is no matter here.
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText.data(), kText.size());
}

}  // namespace

void watchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  for (int s : kSignals) {
    struct sigaction before {};
    // `nohup` and shells in the background ask for signals to be ignored.
    if (sigaction(s, nullptr, &before) == 0 && before.sa_handler == SIG_IGN && s == SIGHUP) continue;
    sigaction(s, &action, nullptr);
  }
}

const std::atomic<bool>& interrupted() { return g_interrupted; }

int interruptExitCode() { return 128 + int(g_signal); }

}  // namespace sb
