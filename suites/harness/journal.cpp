#include "suites/harness/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>

#include "reports/json/json_cell.h"
#include "reports/json/json_field.h"
#include "reports/json/json_read.h"
#include "reports/json/json_stability.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using report::Field;
using report::Json;

constexpr uint64_t kVersion = 2;

std::string lineOf(const Json& json) {
  // File names need not be UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json toJson(const JournalHeader& h) {
  return {{"journal", kVersion},  {"arguments", h.arguments}, {"folder", h.folder},
          {"program", h.program}, {"settings", h.settings},   {"scenes", h.scenes},
          {"devices", h.devices}, {"cells", h.cells},         {"hard_cases", h.hardCases}};
}

std::vector<std::string> textsOf(const Field& list) {
  std::vector<std::string> out;
  for (const Field& item : list.items()) out.push_back(item.text());
  return out;
}

std::map<std::string, std::string> mapOf(const Field& object) {
  std::map<std::string, std::string> out;
  for (const auto& [key, value] : object.members()) out[key] = value.text();
  return out;
}

JournalHeader readHeader(const Field& f) {
  if (f.at("journal").integer<uint64_t>() != kVersion)
    f.at("journal").refuse(std::to_string(kVersion) + ", the version that this program reads");
  return {.arguments = textsOf(f.at("arguments")),
          .folder = f.at("folder").text(),
          .program = f.at("program").text(),
          .settings = mapOf(f.at("settings")),
          .scenes = mapOf(f.at("scenes")),
          .devices = mapOf(f.at("devices")),
          .cells = textsOf(f.at("cells")),
          .hardCases = textsOf(f.at("hard_cases"))};
}

Json toJson(const SampleBlock& block) {
  Json frames = Json::array();
  for (const FrameResult& f : block.frames)
    frames.push_back({f.wallMs, f.cpuMs, f.recordMs, f.submitMs,
                      f.deviceMs ? Json(*f.deviceMs) : Json(nullptr), f.counters.passes,
                      f.counters.draws, f.counters.dispatches, f.counters.triangles});
  return frames;
}

SampleBlock readBlock(const Field& frames) {
  SampleBlock block;
  for (const Field& frame : frames.items()) {
    const auto values = frame.items();
    if (values.size() != 9) frame.refuse("nine numbers");
    FrameResult f;
    f.wallMs = values[0].number();
    f.cpuMs = values[1].number();
    f.recordMs = values[2].number();
    f.submitMs = values[3].number();
    if (!values[4].isNull()) f.deviceMs = values[4].number();
    f.counters = {.passes = values[5].integer<uint64_t>(),
                  .draws = values[6].integer<uint64_t>(),
                  .dispatches = values[7].integer<uint64_t>(),
                  .triangles = values[8].integer<uint64_t>()};
    block.frames.push_back(std::move(f));
  }
  return block;
}

void readLine(const Field& line, JournalContent& content) {
  if (const auto block = line.find("block")) {
    content.blocks[report::readId(block->at("cell"))].push_back(readBlock(block->at("frames")));
  } else if (const auto cell = line.find("cell")) {
    report::Record record = report::readCell(*cell);
    const report::CellId id = record.id;
    content.cells.insert_or_assign(id, std::move(record));
  } else if (const auto hard = line.find("hard_case")) {
    report::StabilityRecord record = report::readStability(*hard);
    const std::string name = record.name();
    content.hardCases.insert_or_assign(name, std::move(record));
  } else {
    line.refuse("a block, a cell or a hard case");
  }
}

void compareMaps(const std::string& kind, const std::map<std::string, std::string>& there,
                 const std::map<std::string, std::string>& here, std::vector<std::string>& out) {
  std::set<std::string> keys;
  for (const auto* map : {&there, &here})
    for (const auto& [key, value] : *map) keys.insert(key);
  const auto valueIn = [](const auto& map, const std::string& key) {
    const auto found = map.find(key);
    return found == map.end() ? std::string("nothing") : found->second;
  };
  for (const std::string& key : keys)
    if (const std::string a = valueIn(there, key), b = valueIn(here, key); a != b)
      out.push_back(kind + " " + key + ": " + a + " there, " + b + " here");
}

void compareNames(const std::string& kind, const std::vector<std::string>& there,
                  const std::vector<std::string>& here, std::vector<std::string>& out) {
  const std::set<std::string> a(there.begin(), there.end()), b(here.begin(), here.end());
  const auto firstMissing = [](const auto& of, const auto& in) {
    return std::ranges::find_if(of, [&](const std::string& name) { return !in.contains(name); });
  };
  if (const auto name = firstMissing(a, b); name != a.end())
    out.push_back(kind + " " + *name + ": only there");
  if (const auto name = firstMissing(b, a); name != b.end())
    out.push_back(kind + " " + *name + ": only here");
}

}  // namespace

std::vector<std::string> differences(const JournalHeader& there, const JournalHeader& here) {
  std::vector<std::string> out;
  if (there.program != here.program)
    out.push_back("program: " + there.program + " there, " + here.program + " here");
  compareMaps("setting", there.settings, here.settings, out);
  compareMaps("scene", there.scenes, here.scenes, out);
  compareMaps("device of", there.devices, here.devices, out);
  compareNames("cell", there.cells, here.cells, out);
  compareNames("hard case", there.hardCases, here.hardCases, out);
  return out;
}

JournalContent readJournal(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError("--resume", "found no journal '" + path.string() + "'");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError("--resume", "cannot read " + path.string());
  JournalContent content;
  size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    // Lines are written whole: without its end, the last one is not.
    if (in.eof()) {
      content.halfLine = true;
      break;
    }
    const std::string where = path.string() + ":" + std::to_string(++number);
    try {
      const Json json = Json::parse(text);
      const Field line(json, where);
      if (number == 1)
        content.header = readHeader(line);
      else
        readLine(line, content);
    } catch (const report::ReadError& e) {
      throw InputError("--resume", e.what());
    } catch (const Json::exception&) {
      throw InputError("--resume", where + ": found no JSON, expected a line of a journal");
    }
    content.wholeBytes += text.size() + 1;
  }
  if (number == 0)
    throw InputError("--resume", path.string() + " holds nothing, expected a journal");
  return content;
}

bool isJournalInUse(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return false;
  const bool used = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(file);
  return used;
}

void Journal::lock() {
  // A file system without locks keeps nobody out, and stops nobody.
  if (m_file < 0 || flock(m_file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(m_file);
  throw InputError("journal", "another run writes " + m_path.string() + " now");
}

Journal::Journal(const std::filesystem::path& path, const JournalHeader& header) : m_path(path) {
  m_file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  lock();
  // What is no regular file has nothing to cut off.
  if (m_file >= 0) (void)!ftruncate(m_file, 0);
  if (m_file >= 0) append(lineOf(toJson(header)), true);
  if (m_file < 0 || !m_failure.empty()) {
    const int code = errno;
    if (m_file >= 0) close(m_file);
    errno = code;
    throw InputError("journal", "cannot write " + path.string() + ": " +
                                    (m_failure.empty() ? std::strerror(errno) : m_failure));
  }
}

Journal::Journal(const std::filesystem::path& path, const JournalContent& content) : m_path(path) {
  m_file = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  lock();
  if (m_file < 0 || ftruncate(m_file, off_t(content.wholeBytes)) != 0) {
    const std::string why = std::strerror(errno);
    if (m_file >= 0) close(m_file);
    throw InputError("journal", "cannot write " + path.string() + ": " + why);
  }
}

Journal::~Journal() {
  if (m_file >= 0) close(m_file);
}

void Journal::block(const report::CellId& cell, const SampleBlock& block) {
  Json id;
  report::putId(id, cell);
  append(lineOf({{"block", {{"cell", std::move(id)}, {"frames", toJson(block)}}}}), false);
}

void Journal::cell(const report::Record& record) {
  append(lineOf({{"cell", report::cellToJson(record)}}), true);
}

void Journal::hardCase(const report::StabilityRecord& record) {
  append(lineOf({{"hard_case", report::stabilityToJson(record)}}), true);
}

void Journal::remove() {
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

void Journal::append(const std::string& line, bool durable) {
  if (!m_failure.empty()) return;
  size_t done = 0;
  while (done < line.size()) {
    const ssize_t written = ::write(m_file, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      m_failure = std::strerror(errno);
      return;
    }
    done += size_t(written);
  }
  // What cannot be synchronised (a pipe) has nothing to lose.
  if (durable) fdatasync(m_file);
}

}  // namespace sb
