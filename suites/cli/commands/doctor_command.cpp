// bench doctor: every device of every backend, and what its timers are worth.
#include <fmt/format.h>

#include <algorithm>

#include "suites/cli/commands/commands.h"
#include "suites/cli/say.h"
#include "suites/cli/vector_width.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

template <class... Args>
void out(fmt::format_string<Args...> format, Args&&... args) {
  print(fmt::format(format, std::forward<Args>(args)...));
}

std::string listOf(const std::vector<uint32_t>& values) {
  std::string out;
  for (uint32_t v : values) out += (out.empty() ? "" : ", ") + std::to_string(v);
  return out;
}

void printDevice(const rhi::DeviceInfo& d) {
  out("  [{}] {} ({})\n", d.index, d.name, rhi::deviceTypeName(d.type));
  if (!d.unusable.empty()) out("      UNUSABLE: {}\n", d.unusable);
  out("      driver {} {}, API {}", d.driver, d.driverVersion, d.apiVersion);
  if (d.memoryBytes > 0) out(", memory {:.1f} GiB", double(d.memoryBytes) / (1 << 30));
  const rhi::Limits& l = d.limits;
  out(
      "\n      textures {}^2 x {} layers, {}^3; {} colour attachments; samples {}; storage range "
      "{} "
      "MiB; sub-pixel bits {}\n      timestamps: {} bits, {} ns\n",
      l.maxTexture2D, l.maxTextureLayers, l.maxTexture3D, l.maxColorAttachments,
      listOf(l.sampleCounts), l.maxStorageRange >> 20, l.subPixelBits, l.timestampBits,
      l.timestampPeriodNs);
  std::string have, lack;
  for (uint32_t f = 0; f < uint32_t(rhi::Feature::Count); ++f) {
    std::string& list = d.features.contains(rhi::Feature(f)) ? have : lack;
    list += (list.empty() ? "" : ", ") + std::string(rhi::featureName(rhi::Feature(f)));
  }
  out("      has: {}\n      lacks: {}\n", have, lack);
}

}  // namespace

int doctorCommand(const Options& options) {
  // Read before the platform takes a width away that no driver survives.
  if (const std::string width = vectorWidth(); !width.empty()) {
    const std::string why = whyNoVectorWidth(width);
    out("WARNING: {}\n", why.empty() ? vectorWidthNote(width)
                                     : "LP_NATIVE_VECTOR_WIDTH " + why + "; ignored here");
  }
  Platform platform = makePlatform(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device.selector, .validate = options.device.validate});
  int working = 0;
  for (rhi::Backend* backend : platform.backends()) {
    out("{}\n", backend->name());
    for (const std::string& trouble : backend->troubles()) out("  WARNING: {}\n", trouble);
    std::fflush(stdout);
    try {
      for (const rhi::DeviceInfo& d : backend->enumerate()) printDevice(d);
    } catch (const rhi::Error& e) {
      out("  not available: {}\n", e.what());
      continue;
    }
    DeviceSession* session = devices.open(std::string(backend->name()));
    if (!session) {
      out("  does not start: {}\n", devices.why(std::string(backend->name())));
      continue;
    }
    ++working;
    out("  timers of {}:\n", session->device->info().name);
    for (const TimerFact& fact : Devices::timersOf(*session))
      out("      {} {}: {}\n", fact.trusted ? "ok       " : "UNTRUSTED", fact.name,
                 fact.finding);
  }
  if (const std::string why = devices.whyNoSuchDevice(); !why.empty())
    throw InputError("--device", why);
  if (working == 0) out("No backend works on this machine.\n");
  return working > 0 ? 0 : 1;
}

}  // namespace sb
