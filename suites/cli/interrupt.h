// Ctrl-C, SIGTERM and SIGHUP: the first is acknowledged at once and stops the run after the block
// under way; a second one ends the program where it stands.
#pragma once

#include <atomic>

namespace sb {

void watchInterrupts();
const std::atomic<bool>& interrupted();
/// 128 + the signal's number.
int interruptExitCode();

}  // namespace sb
