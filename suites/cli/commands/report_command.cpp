// bench report: the HTML page of a run that was written as JSON. No device is opened.
#include <filesystem>

#include "base/atomic_file.h"
#include "reports/bounded_file.h"
#include "reports/html/html.h"
#include "reports/json/json_read.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/say.h"
#include "suites/metrics/blame.h"
#include "suites/metrics/error_map.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

/// Largest file of results that is read.
constexpr uint64_t kResultBytes = uint64_t(1) << 30;

std::string readText(const std::string& path) {
  try {
    return report::readBounded(path, kResultBytes);
  } catch (const std::runtime_error& e) {
    throw InputError("results", e.what());
  }
}

}  // namespace

std::string reportPage(const report::Run& run, const std::filesystem::path& pictures) {
  report::HtmlSettings settings{.pictures = pictures,
                                .errorLeast = double(kErrorMapLeast),
                                .errorMost = double(kErrorMapMost)};
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) settings.errorScale.push_back(scaleColor(float(i) / kSteps));
  for (size_t k = 0; k < kCauses; ++k)
    settings.causeColors.emplace_back(causeName(Cause(k)), causeColor(Cause(k)));
  return report::toHtml(run, settings);
}

int reportCommand(const Options& options) {
  const fs::path json = options.report.results;
  std::string html = options.files.html;
  if (html.empty()) html = fs::path(json).replace_extension(".html");
  requireWritable("--output", html);
  const fs::path pictures = options.report.pictures.empty() ? report::picturesBeside(json)
                                                            : fs::path(options.report.pictures);
  std::error_code error;
  if (!options.report.pictures.empty() && !fs::is_directory(pictures, error))
    throw InputError("--pictures", "found no folder '" + pictures.string() + "'");
  report::Run run;
  try {
    run = report::fromJson(readText(options.report.results), options.report.results);
  } catch (const report::ReadError& e) {
    throw InputError("", e.what());
  }
  base::writeAtomically(html, reportPage(run, pictures));
  // A page that goes to a pipe goes there alone.
  if (!base::isSpecialFile(html)) print(html + "\n");
  return 0;
}

}  // namespace sb
