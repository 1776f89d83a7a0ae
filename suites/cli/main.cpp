// bench: the program. Errors of input exit with 2, failures of cells with 1.
#include <cstdio>

#include "suites/cli/commands.h"
#include "techniques/common/error.h"

int main(int argc, char** argv) {
  try {
    const auto options = sb::parseOptions(argc, argv);
    if (!options) return 0;
    switch (options->command) {
      case sb::Command::Measure:
        return sb::measureCommand(*options);
      case sb::Command::Render:
        return sb::renderCommand(*options);
      case sb::Command::Scene:
        return sb::sceneCommand(*options);
      case sb::Command::Doctor:
        return sb::doctorCommand(*options);
      case sb::Command::Truth:
        return sb::truthCommand(*options);
      case sb::Command::Cache:
        return sb::cacheCommand(*options);
      case sb::Command::Report:
        return sb::reportCommand(*options);
    }
  } catch (const sb::InputError& e) {
    std::fprintf(stderr, "bench: %s\n", e.what());
    return 2;
  } catch (const rhi::Error& e) {
    // A device that was named and is not there is wrong input too.
    std::fprintf(stderr, "bench: %s\n", e.what());
    return e.call() == "device selection" || e.call() == "shader compilation" ? 2 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench: %s\n", e.what());
    return 1;
  }
  return 1;
}
