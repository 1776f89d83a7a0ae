// Which share of a light arrives at a point (spec 16, V-mode and area integration). Lights without
// extent take one ray and are exact. The others are averaged over what the point sees of them: by
// 16 scrambles of the (0,2)-sequence, whose spread gives the standard error, until it is small;
// where nothing stands between, or everything that does hides all of the light evenly, one ray is
// exact. What is sampled is fixed: neither pixel nor thread enters.
#pragma once

#include <functional>
#include <optional>

#include "suites/truth/lights/shaft.h"
#include "suites/truth/rays/ray_scene.h"

namespace sb {

class LightVisibility {
 public:
  explicit LightVisibility(const RayScene& scene);

  struct Answer {
    glm::dvec3 visible = glm::dvec3(1);
    double error = 0;  ///< standard error of the worst channel; 0: exact
    uint32_t rays = 0;
    bool sampled = false;
    bool undefined = false;  ///< the point lies in the light
  };
  /// What is needed for one answer after the other.
  struct Scratch {
    std::vector<TruthHit> hits;
    Bvh::PacketHits packet;
    std::vector<uint32_t> between;
  };
  /// `ownNear`: RayScene::passed.
  Answer ask(uint32_t light, const Tracer::Point& point, const AreaSampling& sampling,
             Scratch& scratch, double ownNear = 0) const;
  struct Query {
    const Tracer::Point* point;
    Answer* answer;
  };
  /// Many questions of one light; cheaper if those that follow one another are neighbours.
  void ask(uint32_t light, std::span<const Query> queries, const AreaSampling& sampling,
           Scratch& scratch) const;
  /// Of radiance 1 from a direction (unit), what is reflected toward the eye, the cosine included.
  using Reflection = std::function<glm::dvec3(const glm::dvec3& toLight)>;
  /// What is reflected of the light's radiance (E-mode). `visible` holds radiance, and `error` is a
  /// share of what would be reflected without shadows.
  Answer integrate(uint32_t light, const Tracer::Point& point, const Reflection& reflection,
                   const AreaSampling& sampling, Scratch& scratch) const;
  bool isArea(uint32_t light) const { return isAreaLight(m_scene.scene().lights[light]); }
  uint64_t bytes() const { return m_tree ? m_tree->bytes() : 0; }

 private:
  class Question;
  /// The answer, if it is the same from everywhere on the light.
  std::optional<glm::dvec3> even(Question& question) const;
  template <class Sample>
  static Answer estimate(const AreaSampling& sampling, const LightPatch& patch, bool traced,
                         const Sample& sample);

  const RayScene& m_scene;
  std::optional<ShaftTree> m_tree;  ///< if there is a light with an extent
};

}  // namespace sb
