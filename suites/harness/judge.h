// How wrong a cell is: the very frame that was verified, and its visibility, against the ray-traced
// truth (spec 16); what is random apart from what is wrong; and what the error is to blame on.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "reports/picture.h"
#include "reports/record.h"
#include "suites/harness/cell.h"
#include "suites/harness/subject.h"
#include "suites/metrics/blame.h"
#include "suites/metrics/noise.h"
#include "suites/truth/tracer.h"

namespace sb {

struct JudgeSettings {
  bool enabled = true;
  uint32_t seeds = 64;          ///< of stochastic techniques; below 2: noise is not measured
  std::filesystem::path cache;  ///< of truths; empty: none
  std::optional<float> exposure;  ///< absent: automatic, from the truth's picture
  const std::atomic<bool>* interrupted = nullptr;
  std::function<void(double)> progress;  ///< of tracing a truth and of a cell's seeds, 0..1
};

/// PNG bytes by content hash.
using PictureFiles = std::map<std::string, std::string>;

class Judge {
 public:
  /// Traces nothing yet. The scene must outlive the judge.
  Judge(const Scene& scene, std::string sceneHash, rhi::Extent2D size, JudgeSettings settings);

  const std::string& sceneHash() const { return m_sceneHash; }
  /// Fills the error keys of a record that is ok, or why they are absent. Draws frames with other
  /// seeds where the technique is stochastic: call after everything that is timed.
  void judge(Subject& subject, const CellId& id, const report::Picture& picture,
             report::Record& record, PictureFiles& files);

 private:
  /// All layers of a light as a technique sees them.
  struct Answer {
    uint32_t light = 0;  ///< index into Scene::lights
    std::vector<VisibilityImage> layers;
    LookupReach reach;
  };

  const Truth* truth();
  /// Of the scene: as set, or from the truth, or from the first picture where there is no truth.
  float exposure(const report::Picture& picture);
  const Tracer& tracer();
  Values truthAt(uint32_t light, uint32_t layer) const;
  std::span<const uint8_t> edgesAt(uint32_t light, uint32_t layer) const;
  void judgeVisibility(const std::vector<Answer>& answers, report::Record& record) const;
  std::vector<std::vector<SeedMoments>> judgeSeeds(Subject& subject, uint32_t seed,
                                                   const std::vector<Answer>& answers,
                                                   report::Record& record);
  /// Regions of the first opaque surfaces; noise where there are moments.
  void judgeRegions(const std::vector<Answer>& answers,
                    const std::vector<std::vector<SeedMoments>>& moments,
                    report::Record& record) const;
  report::NoiseRecord noiseOf(const std::vector<Answer>& answers,
                              const std::vector<std::vector<SeedMoments>>& moments) const;
  /// Least and greatest truth as far as a lookup reaches and in the pixels beside.
  ValueRange truthAround(uint32_t light, uint32_t layer, uint32_t x, uint32_t y,
                         const LookupReach& reach);
  void blame(const std::vector<Answer>& answers,
             const std::vector<std::vector<SeedMoments>>& moments, report::Record& record,
             PictureFiles& files);

  const Scene& m_scene;
  const std::string m_sceneHash;
  const rhi::Extent2D m_size;
  const JudgeSettings m_settings;
  std::string m_why;  ///< no truth, or ""
  std::optional<Truth> m_truth;
  std::optional<float> m_exposure;
  std::unique_ptr<Tracer> m_tracer;
};

}  // namespace sb
