#include "suites/cli/outputs.h"

#include <unistd.h>

#include "base/atomic_file.h"
#include "reports/csv.h"
#include "reports/html/html.h"
#include "reports/json/json.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/output_files.h"
#include "suites/cli/say.h"
#include "techniques/plan/error.h"

namespace sb {

namespace fs = std::filesystem;

fs::path picturesOf(const Options& options, const fs::path& journal) {
  if (!options.files.json.empty() && !base::isSpecialFile(options.files.json))
    return report::picturesBeside(options.files.json);
  return options.files.html.empty() ? fs::path() : report::picturesBeside(journal);
}

Outputs::Outputs(const Options& options) : m_options(options) {
  for (const auto& [option, path] : outputFiles(options)) requireWritable(option, path);
  std::error_code error;
  const fs::path folder = options.files.json.empty() ? fs::path() : picturesOf(options, "");
  if (folder.empty() || !fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error))
    throw InputError("--json", "found a file " + folder.string() +
                                   ", expected the folder of its pictures, or nothing");
  if (const std::string why = base::whyNotWritable(folder / "x.png"); !why.empty())
    throw InputError("--json", "cannot write into " + folder.string() + ": " + why);
}

void Outputs::addPictures(const PictureFiles& files) {
  if (m_pictures.empty() || files.empty()) return;
  try {
    fs::create_directories(m_pictures);
    for (const auto& [hash, png] : files) {
      const fs::path path = m_pictures / (hash + ".png");
      if (!fs::exists(path)) base::writeAtomically(path, png);
    }
  } catch (const std::exception& e) {
    if (m_lostPictures.empty()) say(std::string("warning: pictures are lost: ") + e.what());
    m_lostPictures = e.what();
  }
}

bool Outputs::writeText(const std::string& option, const std::string& path,
                        const std::string& content) {
  if (path.empty()) return true;
  try {
    base::writeAtomically(path, content);
    return true;
  } catch (const std::exception& e) {
    say(option + ": " + e.what());
  }
  const fs::path aside =
      fs::temp_directory_path() /
      ("shadowbench-" + std::to_string(getpid()) + "-" + fs::path(path).filename().string());
  try {
    base::writeAtomically(aside, content);
    say(option + ": the results are in " + aside.string() + " instead");
  } catch (const std::exception& e) {
    say(option + ": nor " + e.what());
  }
  return false;
}

bool Outputs::write(const report::Run& run) {
  bool all = m_lostPictures.empty();
  // Making a page from pictures may fail too.
  auto put = [&](const std::string& option, const std::string& path, auto make) {
    if (path.empty()) return;
    try {
      all &= writeText(option, path, make());
    } catch (const std::exception& e) {
      say(option + ": " + e.what());
      all = false;
    }
  };
  put("--json", m_options.files.json, [&] { return report::toJson(run); });
  put("--csv", m_options.files.csv, [&] { return report::toCsv(run); });
  put("--html", m_options.files.html, [&] { return reportPage(run, m_pictures); });
  return all;
}

}  // namespace sb
