// The commands of the program. Each returns the exit code.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "backends/rhi/device.h"
#include "reports/record.h"
#include "suites/cli/options/options.h"
#include "suites/harness/devices.h"

namespace sb {

int measureCommand(const Options& options);
int renderCommand(const Options& options);
int sceneCommand(const Options& options);
int doctorCommand(const Options& options);
int truthCommand(const Options& options);
int cacheCommand(const Options& options);
int reportCommand(const Options& options);

/// The HTML page of a run. A picture that is missing in `pictures` (<hash>.png) is a note in it.
std::string reportPage(const report::Run& run, const std::filesystem::path& pictures);

/// Backends and shaders that commands share.
struct Platform {
  std::vector<std::unique_ptr<rhi::Backend>> owned;
  rhi::ShaderLibrary shaders;
  std::vector<rhi::Backend*> backends() const;
  std::vector<std::string> names() const;
};
Platform makePlatform(const Options& options);

/// Throws InputError, naming the option, when a file that the command is to write cannot be
/// written.
void requireWritable(const std::string& option, const std::string& path);

/// Backends that a run uses when none is named: "vulkan" and the OpenGL that --gl chose.
std::vector<std::string> defaultBackends(const Options& options);

}  // namespace sb
