// The entries of cells, read back: the inverse of what json.cpp writes for each.
#include <set>

#include "reports/json/json_cell.h"
#include "reports/json/json_read_error.h"

namespace report {
namespace {

std::optional<Distribution> distributionOf(const Field& entry, const std::string& key) {
  const auto f = entry.find(key);
  if (!f) return {};
  return Distribution{.median = f->at("median").number(),
                      .q1 = f->at("q1").number(),
                      .q3 = f->at("q3").number(),
                      .cv = f->at("cv").number(),
                      .n = f->at("n").integer<uint32_t>(),
                      .p95 = numberOf(*f, "p95").value_or(0),
                      .p99 = numberOf(*f, "p99").value_or(0)};
}

Status readStatus(const Field& field) {
  const std::string text = field.text();
  for (Status s : {Status::Ok, Status::Skipped, Status::Failed})
    if (text == statusName(s)) return s;
  field.refuse("\"ok\", \"skipped\" or \"failed\"");
}

void readIdentity(const Field& e, Record& r) {
  r.id = readId(e);
  r.name = e.at("run_name").text();
  if (auto role = e.find("role")) r.role = readRole(*role);
  r.device = textOf(e, "device");
  r.deviceType = textOf(e, "device_type");
  r.driver = textOf(e, "driver");
  r.sceneHash = textOf(e, "scene_hash");
  if (auto knobs = e.find("knobs"))
    for (const auto& [name, value] : knobs->members()) r.knobs[name] = value.text();
  r.version = textOf(e, "version");
}

void readPlan(const Field& e, Record& r) {
  r.effectsPlanned = textsOf(e, "effects_planned");
  if (auto skipped = e.find("effects_skipped"))
    for (const Field& s : skipped->items())
      r.effectsSkipped.emplace_back(s.at("effect").text(), s.at("why").text());
  r.effectsUnrepresented = textsOf(e, "effects_unrepresented");
}

PassRecord readPass(const Field& f) {
  PassRecord pass{.label = f.at("label").text(),
                  .count = f.at("count").integer<uint32_t>(),
                  .ms = f.at("ms").number(),
                  .share = f.at("share").number(),
                  .draws = f.at("draws").integer<uint64_t>(),
                  .triangles = f.at("triangles").integer<uint64_t>(),
                  .fragments = {}};
  if (auto ms = f.find("record_ms")) pass.recordMs = ms->number();
  if (auto fragments = f.find("fragments")) pass.fragments = fragments->integer<uint64_t>();
  return pass;
}

Ratio readRatio(const Field& f) {
  return {.kind = f.at("kind").text(),
          .against = f.at("against").text(),
          .of = f.at("of").text(),
          .value = f.at("ratio").number(),
          .low = f.at("low").number(),
          .high = f.at("high").number(),
          .n = f.at("n").integer<uint32_t>()};
}

void readTimes(const Field& e, Record& r) {
  r.timeSource = textOf(e, "time_source");
  r.frame = distributionOf(e, "frame_ms");
  r.wall = distributionOf(e, "wall_ms");
  r.cpu = distributionOf(e, "cpu_ms");
  r.record = distributionOf(e, "record_ms");
  r.device_ = distributionOf(e, "device_ms");
  r.submitMs = numberOf(e, "submit_ms");
  r.compileMs = numberOf(e, "compile_ms");
  r.droppedFrames = countOf(e, "dropped_frames");
  r.stoppedBy = textOf(e, "stopped_by");
  r.precision = numberOf(e, "precision");
  if (auto passes = e.find("passes"))
    for (const Field& pass : passes->items()) r.passes.push_back(readPass(pass));
  r.shadowMs = numberOf(e, "shadow_ms");
  r.sceneMs = numberOf(e, "scene_ms");
  r.combinedMs = numberOf(e, "combined_ms");
  r.stampedFrameMs = numberOf(e, "stamped_frame_ms");
  if (auto ratios = e.find("ratios"))
    for (const Field& ratio : ratios->items()) r.ratios.push_back(readRatio(ratio));
}

void readResults(const Field& e, Record& r) {
  r.passCount = countOf(e, "pass_count");
  r.drawCount = countOf(e, "draw_count");
  r.triangleCount = countOf(e, "triangle_count");
  r.bytes = countOf(e, "bytes");
  if (auto labels = e.find("bytes_by_label"))
    for (const auto& [label, bytes] : labels->members())
      r.bytesByLabel[label] = bytes.integer<uint64_t>();
  if (auto counts = e.find("counts"))
    for (const auto& [name, count] : counts->members()) r.counts[name] = count.integer<uint64_t>();
  if (auto f = e.find("nonfinite")) r.nonfinite = f->integer<uint64_t>();
  if (auto f = e.find("stable")) r.stable = f->boolean();
  if (auto f = e.find("cross_backend_max_255")) r.crossBackendMax255 = f->signedInteger();
  if (auto f = e.find("cross_backend_over_1_255")) r.crossBackendOver1 = f->integer<uint64_t>();
  r.picture = textOf(e, "picture");
  r.exposure = numberOf(e, "exposure").value_or(1);
  readErrors(e, r);
  if (auto pictures = e.find("pictures"))
    for (const auto& [role, hash] : pictures->members()) r.pictures[role] = hash.text();
}

void readOutcome(const Field& e, Record& r) {
  r.status = readStatus(e.at("status"));
  r.reason = textOf(e, "reason");
  r.warnings = textsOf(e, "warnings");
  r.contamination = textsOf(e, "contamination");
  r.command = textOf(e, "command");
  for (const auto& [key, value] : e.members())
    if (key.ends_with("_why")) r.why[key.substr(0, key.size() - 4)] = value.text();
}

/// Milliseconds that one of Google Benchmark's units has.
double millisecondsOf(const Field& unit) {
  static const std::map<std::string, double> kUnits = {
      {"ns", 1e-6}, {"us", 1e-3}, {"ms", 1}, {"s", 1e3}};
  const auto known = kUnits.find(unit.text());
  if (known == kUnits.end()) unit.refuse("\"ns\", \"us\", \"ms\" or \"s\"");
  return known->second;
}

Block readBlock(const Field& e) {
  const double unit = millisecondsOf(e.at("time_unit"));
  return {.frames = e.at("iterations").integer<uint32_t>(),
          .frameMs =
              numberOf(e, "frame_mean_ms").value_or(e.at("real_time").number() * unit),
          .cpuMs = numberOf(e, "cpu_mean_ms").value_or(e.at("cpu_time").number() * unit)};
}

/// Files from before rows said what they are: the tracer alone ran on no API, and what costs of
/// others were told against is a baseline.
void tellRoles(std::vector<Record>& records) {
  std::set<std::string> baselines;
  for (const Record& r : records)
    for (const Ratio& ratio : r.ratios)
      if (ratio.kind == "baseline") baselines.insert(ratio.against);
  for (Record& r : records) {
    if (r.id.backend == kTracerBackend) r.role = Role::Tracer;
    if (baselines.contains(r.name)) r.role = Role::Baseline;
  }
}

}  // namespace

CellId readId(const Field& e) {
  CellId id{.technique = e.at("technique").text(),
            .backend = e.at("backend").text(),
            .scene = e.at("scene").text(),
            .width = e.at("width").integer<uint32_t>(),
            .height = e.at("height").integer<uint32_t>()};
  if (auto transparency = e.find("transparency")) id.transparency = transparency->text();
  if (auto lights = e.find("lights")) id.lights = lights->text();
  // Files from before it was said which were changed: whatever is set counts.
  if (const auto changed = e.find("knobs_changed"))
    for (const Field& name : changed->items())
      id.knobs.emplace_back(name.text(), e.at("knobs").at(name.text()).text());
  else if (const auto knobs = e.find("knobs"))
    for (const auto& [name, value] : knobs->members()) id.knobs.emplace_back(name, value.text());
  if (auto seed = e.find("seed")) id.seed = seed->integer<uint32_t>();
  return id;
}

Role readRole(const Field& field) {
  const std::string text = field.text();
  for (const Role role : kRoles)
    if (text == roleName(role)) return role;
  field.refuse("\"technique\", \"baseline\" or \"tracer\"");
}

std::vector<Record> readRecords(const Field& list) {
  std::vector<Record> records;
  std::map<std::string, std::vector<Block>> blocks;
  bool toldRoles = false;
  for (const Field& entry : list.items()) {
    const std::string type = entry.at("run_type").text();
    if (type == "iteration") {
      blocks[entry.at("run_name").text()].push_back(readBlock(entry));
      continue;
    }
    if (type != "aggregate") entry.at("run_type").refuse("\"iteration\" or \"aggregate\"");
    Record r;
    readIdentity(entry, r);
    toldRoles |= entry.find("role").has_value();
    readPlan(entry, r);
    readTimes(entry, r);
    readResults(entry, r);
    readOutcome(entry, r);
    r.blocks = std::move(blocks[r.name]);
    blocks.erase(r.name);
    records.push_back(std::move(r));
  }
  if (!toldRoles) tellRoles(records);
  return records;
}

Record readCell(const Field& entries) {
  std::vector<Record> records = readRecords(entries);
  if (records.size() != 1) entries.refuse("the entries of one cell");
  return std::move(records.front());
}

}  // namespace report
