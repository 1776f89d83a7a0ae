#include "tests/reports/sample_run.h"

namespace report {
namespace {

Record identity(const std::string& technique, const std::string& backend) {
  Record r = {.id = {.technique = technique,
                     .backend = backend,
                     .scene = "layers",
                     .knobs = {{"size", "1024"}},
                     .width = 64,
                     .height = 32,
                     .seed = 4294967295u},
              .sceneHash = "0123456789abcdef",
              .knobs = {{"kernel", "3"}, {"size", "1024"}},
              .version = "0.1.0",
              .command = "./bench --technique " + technique};
  r.name = technique + "/" + backend + "/layers/64x32";
  for (const char* key : {"visibility", "image", "noise", "truth_stderr"})
    r.why[key] = "no truth, \"here\"";
  return r;
}

ErrorStats stats(double rmse) {
  return {.rmse = rmse,
          .bias = -0.0625,
          .max = 1,
          .p999 = 0.75,
          .over1 = 0.25,
          .rmseRgb = {rmse, rmse / 2, rmse / 4},
          .biasRgb = {-0.125, -0.0625, 0},
          .pixels = 2048};
}

void addErrors(Record& r) {
  r.why = {{"device_ms", "plain frames carry no stamps"}};
  r.visibility = VisibilityError{stats(0.125), stats(0.03125), 7, 3};
  r.visibilityLayers = {
      {.light = 0, .lightName = "sun <1>", .layer = 0, .error = {stats(0.125), stats(0.03125)}}};
  r.visibilityRegions = {
      {.region = "dark", .share = 0.25, .rmse = 0.5, .bias = 0.125, .noise = 0.0625},
      {.region = "pale", .share = 0.75, .rmse = 0.25, .bias = -0.125, .noise = {}}};
  r.image = ImageError{.all = stats(0.25),
                       .interior = stats(0.0625),
                       .relmse = 0.5,
                       .relmseInterior = 0.25,
                       .flip = 0.375,
                       .flipInterior = 0.125};
  r.noise = NoiseRecord{.seeds = 64,
                        .noise = 0.0625,
                        .biasRmse = 0.03125,
                        .bias = 0.015625,
                        .biasLow = 0.0078125,
                        .biasHigh = 0.0234375,
                        .rmseLow = 0.1,
                        .rmseHigh = 0.15};
  r.certificate = Certificate{.unbiased = true,
                              .informative = 1,
                              .regions = {{.light = 0,
                                           .layer = 1,
                                           .channel = 2,
                                           .x = 3,
                                           .y = 4,
                                           .pixels = 100,
                                           .q = 0.5,
                                           .trials = 1000,
                                           .passes = 510,
                                           .mean = 0.51,
                                           .error = 0.015625,
                                           .pValue = 0.5}}};
  r.blame = Blame{.mse = 0.015625,
                  .shares = {{"noise", 0.25},
                             {"resolution", 0.5},
                             {"inner-layer", 0},
                             {"self-shadowing", 0.125},
                             {"leaking", 0.125}}};
  r.truthStderr = 0;
  r.pictures = {{"image", "fedcba9876543210"}, {"truth", "00000000000000aa"}};
}

Record good() {
  Record r = identity("ShadowMap", "vulkan");
  r.device = "llvmpipe, 256 bits";
  r.deviceType = "software";
  r.driver = "Mesa \"22\"";
  r.effectsPlanned = {"opaque casters"};
  r.effectsSkipped = {{"area lights", "every light is a point"}};
  r.effectsUnrepresented = {"translucent casters"};
  r.timeSource = "software";
  r.frame = Distribution{.median = 2.5, .q1 = 2.25, .q3 = 3, .cv = 0.125, .n = 4};
  r.wall = r.frame;
  r.cpu = Distribution{.median = 5, .q1 = 4.5, .q3 = 5.5, .cv = 0.0625, .n = 4};
  r.record = Distribution{.median = 0.25, .q1 = 0.25, .q3 = 0.25, .cv = 0, .n = 4};
  r.submitMs = 0.5;
  r.compileMs = 400;
  r.passes = {{.label = "shadow map",
               .ms = 1,
               .share = 0.25,
               .recordMs = 0.0625,
               .draws = 1,
               .triangles = 12,
               .fragments = 4096},
              {.label = "camera", .ms = 2, .share = 0.5, .draws = 2, .triangles = 24}};
  r.shadowMs = 1;
  r.sceneMs = 2;
  r.combinedMs = 3;
  r.stampedFrameMs = 4;
  r.ratios = {{.kind = "baseline",
               .against = "none/vulkan/layers/64x32",
               .of = "cpu_ms",
               .value = 2,
               .low = 1.5,
               .high = 2.5,
               .n = 2},
              {.kind = "backend",
               .against = "ShadowMap/opengl/layers/64x32",
               .of = "cpu_ms",
               .value = 1.25,
               .low = 1.125,
               .high = 1.5,
               .n = 2}};
  r.blocks = {{.frames = 2, .frameMs = 2.5, .cpuMs = 5}, {.frames = 2, .frameMs = 3, .cpuMs = 4}};
  r.stoppedBy = "precision";
  r.precision = 0.04;
  r.passCount = 2;
  r.drawCount = 3;
  r.triangleCount = 36;
  r.bytes = 3 << 20;
  r.bytesByLabel = {{"camera colour", 1 << 20}, {"shadow map", 2 << 20}};
  r.counts = {{"volumes drawn", 5}};
  r.stable = true;
  r.crossBackendMax255 = 1;
  r.crossBackendOver1 = 0;
  r.nonfinite = 0;
  r.picture = "fedcba9876543210";
  addErrors(r);
  return r;
}

Record disturbed() {
  Record r = good();
  r.name = "ShadowMap/opengl/layers/64x32";
  r.id.backend = "opengl";
  r.crossBackendMax255 = 9;
  r.crossBackendOver1 = 17;
  r.ratios.clear();
  r.why["ratios"] = "contaminated: other programs used 80 % of the CPUs";
  r.contamination = {"other programs used 80 % of the CPUs"};
  r.stoppedBy = "budget";
  r.warnings = {"ten warm-up windows did not agree: the time drifts"};
  r.passes.clear();
  r.shadowMs = r.sceneMs = r.combinedMs = r.stampedFrameMs = {};
  for (const char* key : {"passes", "shadow_ms", "scene_ms", "combined_ms", "stamped_frame_ms"})
    r.why[key] = "timer not trusted";
  return r;
}

}  // namespace

Run sampleRun() {
  Run run = {.date = "2022-01-01T00:00:00+0000",
             .host = "host",
             .executable = "bench",
             .version = "0.1.0",
             .buildType = "release",
             .cpus = 2,
             .cpuMHz = 2500,
             .cpuScaling = true,
             .loadAverage = {0.5, 0.25, 0.125},
             .warnings = {"backend opengl-osmesa does not start: no library"},
             .records = {good(), disturbed()}};
  Record skipped = identity("CSSM2", "vulkan");
  skipped.status = Status::Skipped;
  skipped.reason = "the device lacks geometry-shader";
  run.records.push_back(skipped);
  Record failed = good();
  failed.name = "CSSM2/opengl/layers/64x32";
  failed.id.technique = "CSSM2";
  failed.id.backend = "opengl";
  refuse(failed, "3 values of the picture are not finite,\nor so");
  run.records.push_back(failed);
  return run;
}

}  // namespace report
