#include "suites/cli/outputs.h"

#include "reports/atomic_file.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "suites/cli/commands.h"

namespace sb {

std::filesystem::path picturesFolder(const std::filesystem::path& jsonFile) {
  std::filesystem::path folder = jsonFile;
  return folder.replace_extension(".pictures");
}

Outputs::Outputs(const Options& options) : m_options(options) {
  if (!options.jsonFile.empty()) requireWritable("--json", options.jsonFile);
  if (!options.csvFile.empty()) requireWritable("--csv", options.csvFile);
  if (!options.htmlFile.empty()) requireWritable("--html", options.htmlFile);
  if (!options.benchmark.outFile.empty())
    requireWritable("--benchmark_out", options.benchmark.outFile);
  if (!options.jsonFile.empty() && !report::isSpecialFile(options.jsonFile))
    m_pictures = picturesFolder(options.jsonFile);
}

void Outputs::addPictures(PictureFiles files) {
  if (!m_pictures.empty() && !files.empty()) {
    std::filesystem::create_directories(m_pictures);
    for (const auto& [hash, png] : files) {
      const std::filesystem::path path = m_pictures / (hash + ".png");
      if (!std::filesystem::exists(path)) report::writeAtomically(path, png);
    }
  }
  if (!m_options.htmlFile.empty()) m_files.merge(files);
}

void Outputs::write(const report::Run& run, bool finished) {
  auto due = [&](const std::string& path) {
    return !path.empty() && (finished || !report::isSpecialFile(path));
  };
  if (due(m_options.jsonFile)) report::writeAtomically(m_options.jsonFile, report::toJson(run));
  if (due(m_options.csvFile)) report::writeAtomically(m_options.csvFile, report::toCsv(run));
}

}  // namespace sb
