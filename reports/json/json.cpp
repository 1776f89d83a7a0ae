#include "reports/json/json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/json/json_cell.h"
#include "reports/json/json_error.h"
#include "reports/json/json_figure.h"
#include "reports/json/json_stability.h"
#include "reports/stats/stats.h"

namespace report {
namespace {

/// null for what is absent.
template <class T>
void put(Json& out, const Record& r, const std::string& key, const std::optional<T>& value) {
  out[key] = value ? Json(*value) : Json(nullptr);
  putWhy(out, r, key, !value);
}

void put(Json& out, const Record& r, const std::string& key,
         const std::optional<Distribution>& value) {
  if (!value) return put(out, r, key, std::optional<double>());
  out[key] = {{"median", value->median},
              {"q1", value->q1},
              {"q3", value->q3},
              {"cv", value->cv},
              {"n", value->n},
              {"p95", value->p95},
              {"p99", value->p99}};
}

void putIdentity(Json& out, const Record& r) {
  putId(out, r.id);
  out["knobs"] = r.knobs;
  out["role"] = roleName(r.role);
  out["device"] = r.device;
  out["device_type"] = r.deviceType;
  out["driver"] = r.driver;
  out["scene_hash"] = r.sceneHash;
  out["version"] = r.version;
}

void putPlan(Json& out, const Record& r) {
  out["effects_planned"] = r.effectsPlanned;
  out["effects_skipped"] = Json::array();
  for (const auto& [effect, why] : r.effectsSkipped)
    out["effects_skipped"].push_back({{"effect", effect}, {"why", why}});
  out["effects_unrepresented"] = r.effectsUnrepresented;
}

void putTimes(Json& out, const Record& r) {
  out["time_source"] = r.timeSource;
  put(out, r, "frame_ms", r.frame);
  put(out, r, "wall_ms", r.wall);
  put(out, r, "cpu_ms", r.cpu);
  put(out, r, "record_ms", r.record);
  put(out, r, "device_ms", r.device_);
  put(out, r, "submit_ms", r.submitMs);
  put(out, r, "compile_ms", r.compileMs);
  out["dropped_frames"] = r.droppedFrames;
  out["stopped_by"] = r.stoppedBy;
  put(out, r, "precision", r.precision);
  out["passes"] = Json::array();
  putWhy(out, r, "passes", r.passes.empty());
  for (const PassRecord& p : r.passes) {
    Json pass = {{"label", p.label},
                 {"count", p.count},
                 {"ms", p.ms},
                 {"share", p.share},
                 {"record_ms", p.recordMs},
                 {"draws", p.draws},
                 {"triangles", p.triangles}};
    pass["fragments"] = p.fragments ? Json(*p.fragments) : Json(nullptr);
    if (!p.fragments) pass["fragments_why"] = "not counted: no query, or a pass without fragments";
    out["passes"].push_back(std::move(pass));
  }
  put(out, r, "shadow_ms", r.shadowMs);
  put(out, r, "scene_ms", r.sceneMs);
  put(out, r, "combined_ms", r.combinedMs);
  put(out, r, "stamped_frame_ms", r.stampedFrameMs);
  out["ratios"] = Json::array();
  putWhy(out, r, "ratios", r.ratios.empty());
  for (const Ratio& x : r.ratios)
    out["ratios"].push_back({{"kind", x.kind},
                             {"against", x.against},
                             {"of", x.of},
                             {"ratio", x.value},
                             {"low", x.low},
                             {"high", x.high},
                             {"n", x.n}});
}

void putResults(Json& out, const Record& r) {
  out["pass_count"] = r.passCount;
  out["draw_count"] = r.drawCount;
  out["triangle_count"] = r.triangleCount;
  out["bytes"] = r.bytes;
  out["bytes_by_label"] = r.bytesByLabel;
  out["counts"] = r.counts;
  put(out, r, "nonfinite", r.nonfinite);
  put(out, r, "stable", r.stable);
  put(out, r, "cross_backend_max_255", r.crossBackendMax255);
  put(out, r, "cross_backend_over_1_255", r.crossBackendOver1);
  out["picture"] = r.picture;
  out["exposure"] = r.exposure;
  putErrors(out, r);
  out["pictures"] = r.pictures;
}

void putOutcome(Json& out, const Record& r) {
  out["status"] = statusName(r.status);
  out["reason"] = r.reason;
  out["warnings"] = r.warnings;
  out["contamination"] = r.contamination;
  out["command"] = r.command;
}

/// Google Benchmark's keys are in microseconds: its compare.py shows no digits after the point.
constexpr double kMicroseconds = 1e3;

/// Google Benchmark's median: over repetitions, not over frames.
double medianOf(const std::vector<Block>& blocks, double Block::*member) {
  std::vector<double> values;
  for (const Block& b : blocks) values.push_back(b.*member);
  return median(values);
}

Json googleKeys(const Record& r, const std::string& suffix, const char* runType) {
  return {{"name", r.name + suffix},
          {"run_name", r.name},
          {"run_type", runType},
          {"repetitions", r.blocks.size()},
          {"threads", 1}};
}

void appendCell(Json& list, const Record& r) {
  if (r.status != Status::Ok) {
    // A name and a type of its own: compare.py looks for times in all iterations, and in all
    // entries whose names are in both files.
    const std::string status(statusName(r.status));
    Json entry = googleKeys(r, "_" + status, "aggregate");
    entry["aggregate_name"] = status;
    entry["error_occurred"] = true;
    entry["error_message"] = status + ": " + r.reason;
    putIdentity(entry, r);
    putPlan(entry, r);
    putOutcome(entry, r);
    list.push_back(std::move(entry));
    return;
  }
  uint64_t frames = 0;
  for (size_t i = 0; i < r.blocks.size(); ++i) {
    Json entry = googleKeys(r, "", "iteration");
    entry["repetition_index"] = i;
    entry["iterations"] = r.blocks[i].frames;
    entry["real_time"] = r.blocks[i].frameMs * kMicroseconds;
    entry["cpu_time"] = r.blocks[i].cpuMs * kMicroseconds;
    entry["time_unit"] = "us";
    // As they were measured: a change of unit may round.
    entry["frame_mean_ms"] = r.blocks[i].frameMs;
    entry["cpu_mean_ms"] = r.blocks[i].cpuMs;
    frames += r.blocks[i].frames;
    list.push_back(std::move(entry));
  }
  Json entry = googleKeys(r, "_median", "aggregate");
  entry["aggregate_name"] = "median";
  entry["aggregate_unit"] = "time";
  entry["iterations"] = frames;
  entry["real_time"] = medianOf(r.blocks, &Block::frameMs) * kMicroseconds;
  entry["cpu_time"] = medianOf(r.blocks, &Block::cpuMs) * kMicroseconds;
  entry["time_unit"] = "us";
  putIdentity(entry, r);
  putPlan(entry, r);
  putTimes(entry, r);
  putResults(entry, r);
  putOutcome(entry, r);
  list.push_back(std::move(entry));
}

}  // namespace

void putId(Json& out, const CellId& id) {
  out["technique"] = id.technique;
  out["transparency"] = id.transparency;
  out["lights"] = id.lights;
  out["backend"] = id.backend;
  out["scene"] = id.scene;
  out["width"] = id.width;
  out["height"] = id.height;
  out["knobs"] = Json::object();
  out["knobs_changed"] = Json::array();
  for (const auto& [knob, value] : id.knobs) {
    out["knobs"][knob] = value;
    out["knobs_changed"].push_back(knob);
  }
  out["seed"] = id.seed;
}

Json cellToJson(const Record& record) {
  Json list = Json::array();
  appendCell(list, record);
  return list;
}

std::string toJson(const Run& run) {
  Json caches = Json::array();
  for (const Cache& c : run.caches)
    caches.push_back(
        {{"type", c.type}, {"level", c.level}, {"size", c.bytes}, {"num_sharing", c.sharing}});
  Json context = {{"date", run.date},
                  {"host_name", run.host},
                  {"executable", run.executable},
                  {"num_cpus", run.cpus},
                  {"mhz_per_cpu", std::lround(run.cpuMHz)},
                  {"cpu_scaling_enabled", run.cpuScaling},
                  {"caches", std::move(caches)},
                  {"load_avg", run.loadAverage},
                  {"library_version", run.libraryVersion},
                  {"library_build_type", run.buildType},
                  {"json_schema_version", 1},
                  {"shadowbench_version", run.version},
                  {"warnings", run.warnings},
                  {"commit", run.commit},
                  {"compiler", run.compiler},
                  {"os", run.os},
                  {"cpu_model", run.cpuModel},
                  {"command_line", run.commandLine},
                  {"interrupted", run.interrupted},
                  {"cells_planned", run.cellsPlanned},
                  {"cells_done", run.cellsDone}};
  Json benchmarks = Json::array();
  for (const Record& r : run.records) appendCell(benchmarks, r);
  Json out = {{"context", std::move(context)}, {"benchmarks", std::move(benchmarks)}};
  for (const StabilityRecord& r : run.stability) out["stability"].push_back(stabilityToJson(r));
  for (const Figure& f : run.figures) out["figures"].push_back(figureToJson(f, run));
  // Names of files need not be UTF-8.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace report
