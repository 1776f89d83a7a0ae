#include "suites/cli/outputs.h"

#include <unistd.h>

#include "reports/atomic_file.h"
#include "reports/csv.h"
#include "reports/html/html.h"
#include "reports/json.h"
#include "suites/cli/commands.h"

namespace sb {

namespace fs = std::filesystem;

Outputs::Outputs(const Options& options) : m_options(options) {
  if (!options.jsonFile.empty()) requireWritable("--json", options.jsonFile);
  if (!options.csvFile.empty()) requireWritable("--csv", options.csvFile);
  if (!options.htmlFile.empty()) requireWritable("--html", options.htmlFile);
  if (!options.benchmark.outFile.empty())
    requireWritable("--benchmark_out", options.benchmark.outFile);
  if (!options.jsonFile.empty() && !report::isSpecialFile(options.jsonFile)) {
    m_pictures = report::picturesBeside(options.jsonFile);
  } else if (!options.htmlFile.empty()) {
    m_pictures = fs::temp_directory_path() / ("shadowbench-" + std::to_string(getpid()));
    m_ownsFolder = true;
  }
}

Outputs::~Outputs() {
  std::error_code error;
  if (m_ownsFolder) fs::remove_all(m_pictures, error);
}

void Outputs::addPictures(const PictureFiles& files) {
  if (m_pictures.empty() || files.empty()) return;
  fs::create_directories(m_pictures);
  for (const auto& [hash, png] : files) {
    const fs::path path = m_pictures / (hash + ".png");
    if (!fs::exists(path)) report::writeAtomically(path, png);
  }
}

void Outputs::write(const report::Run& run, bool finished) {
  auto due = [&](const std::string& path) {
    return !path.empty() && (finished || !report::isSpecialFile(path));
  };
  if (due(m_options.jsonFile)) report::writeAtomically(m_options.jsonFile, report::toJson(run));
  if (due(m_options.csvFile)) report::writeAtomically(m_options.csvFile, report::toCsv(run));
  if (finished && !m_options.htmlFile.empty()) writeReport(run, m_options.htmlFile, m_pictures);
}

}  // namespace sb
