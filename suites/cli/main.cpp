// bench: the program. Errors of input exit with 2, failures of cells and of output with 1.
#include <algorithm>
#include <new>

#include "suites/cli/commands/commands.h"
#include "suites/cli/say.h"
#include "techniques/plan/error.h"

namespace {

int runCommand(const sb::Options& options) {
  switch (options.command) {
    case sb::Command::Measure:
      return sb::measureCommand(options);
    case sb::Command::Render:
      return sb::renderCommand(options);
    case sb::Command::Scene:
      return sb::sceneCommand(options);
    case sb::Command::Doctor:
      return sb::doctorCommand(options);
    case sb::Command::Truth:
      return sb::truthCommand(options);
    case sb::Command::Cache:
      return sb::cacheCommand(options);
    case sb::Command::Report:
      return sb::reportCommand(options);
  }
  return 1;
}

int guarded(int argc, char** argv) {
  try {
    const auto options = sb::parseOptions({argv + std::min(argc, 1), argv + argc});
    return options ? runCommand(*options) : 0;
  } catch (const sb::InputError& e) {
    sb::say(e.what());
    return 2;
  } catch (const rhi::Error& e) {
    // A device that was named and is not there is wrong input too.
    sb::say(e.what());
    return e.call() == "device selection" || e.call() == "shader compilation" ? 2 : 1;
  } catch (const std::bad_alloc&) {
    sb::say("out of memory: what was asked for does not fit (see --max-memory)");
    return 1;
  } catch (const std::exception& e) {
    sb::say(e.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int code = guarded(argc, argv);
  if (sb::printed()) return code;
  sb::say("standard output: writing failed");
  return std::max(code, 1);
}
