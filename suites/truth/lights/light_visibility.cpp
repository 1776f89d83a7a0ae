#include "suites/truth/lights/light_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "suites/truth/lights/scrambles.h"
#include "suites/truth/lights/shadow_rays.h"

namespace sb {

using glm::dvec3;

namespace {

using Sums = std::array<dvec3, kScrambles>;

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

dvec3 meanOf(const Sums& sums, uint32_t points) {
  dvec3 sum(0);
  for (const dvec3& s : sums) sum += s;
  return sum / double(kScrambles * points);
}

/// Standard error of the mean of the scrambles, worst channel.
double spread(const Sums& sums, uint32_t points) {
  const dvec3 mean = meanOf(sums, points);
  dvec3 squares(0);
  for (const dvec3& sum : sums) {
    const dvec3 off = sum / double(points) - mean;
    squares += off * off;
  }
  return std::sqrt(largest(squares) / (kScrambles * (kScrambles - 1)));
}

}  // namespace

/// One point and one light.
class LightVisibility::Question {
 public:
  Question(const LightVisibility& owner, uint32_t light, const Tracer::Point& point,
           Scratch& scratch, double ownNear)
      : m_scene(owner.m_scene),
        m_point(point),
        m_scratch(scratch),
        m_ownNear(ownNear),
        m_target(m_scene.target(light, point.position)),
        m_patch(lightPatch(m_scene.scene().lights[light], m_target.toward)) {}

  using Target = RayScene::Target;

  const LightPatch& patch() const { return m_patch; }

  Target at(const glm::dvec2& place) const {
    const dvec3 offset = m_patch.offset(place);
    Target at{.toward = m_patch.centre + offset,
              .place = m_target.place + offset,
              .infinite = m_patch.infinite};
    if (!at.infinite) at.toward = at.place - m_point.position;
    return at;
  }
  dvec3 toCentre() { return m_scene.passed(m_point, m_target, m_scratch.hits, m_ownNear); }
  /// A place on the light, and what reaches the point from it.
  struct Place {
    Target target;
    dvec3 passed = dvec3(0);
  };
  void pass(std::span<Place> places) {
    struct {
      const Question& question;
      std::span<Place> places;
      const Tracer::Point& point(size_t) const { return question.m_point; }
      const Target& target(size_t i) const { return places[i].target; }
      double ownNear() const { return question.m_ownNear; }
      void end(size_t i, const dvec3& passed) { places[i].passed = passed; }
    } rays{*this, places};
    m_scene.pass(places.size(), rays, m_scratch.packet);
  }

  /// Finds what may be between. An answer if that is the same from everywhere on the light.
  std::optional<dvec3> lookAround(const ShaftTree& tree) {
    const Shaft shaft(m_point.position, m_patch, 0x1p-40 * m_scene.extent());
    std::vector<uint32_t>& between = m_scratch.between;
    tree.gather(shaft, between);
    std::erase_if(between, [&](uint32_t t) {
      return m_scene.isOwn(t, m_point) || (!m_patch.infinite && holdsLight(t, shaft));
    });
    bool even = true;
    for (const uint32_t t : between) {
      const SurfaceTraits& traits = m_scene.traits(t);
      const bool covers = (m_ownNear == 0 || m_scene.triangles()[t].instance != m_point.instance) &&
                          !traits.material.textured &&
                          traits.material.lightClass != MaterialClass::Perforated &&
                          shaft.isCoveredBy(m_scene.triangles()[t]);
      if (covers && traits.blocks) return dvec3(0);
      even &= covers;
    }
    if (between.empty()) return dvec3(1);
    return even ? std::optional(toCentre()) : std::nullopt;
  }

 private:
  /// Lies all of the light in the triangle's plane?
  bool holdsLight(uint32_t triangle, const Shaft& shaft) const {
    return std::ranges::all_of(shaft.corners(), [&](const dvec3& corner) {
      return m_scene.isInPlane(triangle, m_target.place + (corner - m_patch.centre));
    });
  }

  const RayScene& m_scene;
  const Tracer::Point& m_point;
  Scratch& m_scratch;
  const double m_ownNear;
  const Target m_target;
  const LightPatch m_patch;
};

LightVisibility::LightVisibility(const RayScene& scene) : m_scene(scene) {
  if (std::ranges::any_of(scene.scene().lights, isAreaLight)) m_tree.emplace(scene.triangles());
}

/// `sample` gives the values at up to kPacket places on the patch and what they would be without
/// shadows. `traced`: the difference comes from rays.
template <class Sample>
LightVisibility::Answer LightVisibility::estimate(const AreaSampling& sampling,
                                                  const LightPatch& patch, bool traced,
                                                  const Sample& sample) {
  const ScrambledPlaces& places = patch.round ? scrambledDisc() : scrambledSquare();
  Answer answer{.sampled = true};
  Sums sums{}, unshadowed{};
  uint32_t done = 0;
  for (uint32_t points = sampling.first / kScrambles;; points *= 2) {
    for (uint32_t k = 0; k < kScrambles; ++k)
      for (uint32_t i = done; i < points; i += kPacket) {
        const uint32_t count = std::min(kPacket, points - i);
        std::array<dvec3, kPacket> values, full;
        sample(std::span(places[k]).subspan(i, count), values, full);
        for (uint32_t s = 0; s < count; ++s) {
          sums[k] += values[s];
          unshadowed[k] += full[s];
        }
      }
    done = points;
    const uint32_t samples = kScrambles * points;
    answer.rays = traced ? samples : 1;
    answer.visible = meanOf(sums, points);
    const double full = largest(meanOf(unshadowed, points));
    answer.error = full > 0 ? spread(sums, points) / full : 0;
    // What covers less than a sample's share of the light may be missed by all.
    if (traced) answer.error = std::max(answer.error, 1.0 / samples);
    if (answer.error < sampling.error || samples >= sampling.most) return answer;
  }
}

std::optional<dvec3> LightVisibility::even(Question& question) const {
  const std::optional<dvec3> answer = question.lookAround(*m_tree);
  // What hides all of a light hides it; media are as thick as the way to each part of it is long.
  if (answer && *answer != dvec3(0) && !m_scene.media().empty()) return {};
  return answer;
}

LightVisibility::Answer LightVisibility::ask(uint32_t light, const Tracer::Point& point,
                                             const AreaSampling& sampling, Scratch& scratch,
                                             double ownNear) const {
  if (!isArea(light))
    return {.visible =
                m_scene.passed(point, m_scene.target(light, point.position), scratch.hits, ownNear),
            .rays = 1};
  Question question(*this, light, point, scratch, ownNear);
  if (question.patch().inside) return {.undefined = true};
  if (sampling.pattern > 0) {
    Answer answer{.visible = dvec3(0), .rays = sampling.pattern};
    std::array<Question::Place, kPacket> rays;
    for (uint32_t first = 0; first < sampling.pattern; first += kPacket) {
      const auto some = std::span(rays).first(std::min(kPacket, sampling.pattern - first));
      for (uint32_t i = 0; i < some.size(); ++i) {
        const glm::dvec2 square = netPoint(first + i, sampling.pattern);
        some[i].target = question.at(question.patch().round ? onDisc(square) : onSquare(square));
      }
      question.pass(some);
      for (const Question::Place& ray : some) answer.visible += ray.passed;
    }
    answer.visible /= double(sampling.pattern);
    return answer;
  }
  if (const auto all = even(question)) return {.visible = *all, .rays = 1};
  std::array<Question::Place, kPacket> rays;
  return estimate(
      sampling, question.patch(), true,
      [&](std::span<const glm::dvec2> places, std::span<dvec3> values, std::span<dvec3> full) {
        for (size_t i = 0; i < places.size(); ++i) rays[i].target = question.at(places[i]);
        question.pass(std::span(rays).first(places.size()));
        for (size_t i = 0; i < places.size(); ++i) values[i] = rays[i].passed, full[i] = dvec3(1);
      });
}

void LightVisibility::ask(uint32_t light, std::span<const Query> queries,
                          const AreaSampling& sampling, Scratch& scratch) const {
  if (isArea(light)) {
    for (const Query& q : queries) *q.answer = ask(light, *q.point, sampling, scratch);
    return;
  }
  struct {
    const RayScene& scene;
    uint32_t light;
    std::span<const Query> queries;
    const Tracer::Point& point(size_t i) const { return *queries[i].point; }
    RayScene::Target target(size_t i) const { return scene.target(light, point(i).position); }
    double ownNear() const { return 0; }
    void end(size_t i, const dvec3& passed) { *queries[i].answer = {.visible = passed, .rays = 1}; }
  } rays{m_scene, light, queries};
  m_scene.pass(queries.size(), rays, scratch.packet);
}

LightVisibility::Answer LightVisibility::integrate(uint32_t light, const Tracer::Point& point,
                                                   const Reflection& reflection,
                                                   const AreaSampling& sampling,
                                                   Scratch& scratch) const {
  Question question(*this, light, point, scratch, 0);
  const LightPatch& patch = question.patch();
  if (patch.inside) return {.visible = dvec3(0), .undefined = true};
  // The illumination from the centre, as if at unit distance.
  const dvec3 power = patch.power * dvec3(m_scene.illumination(light, point).radiance) *
                      (patch.infinite ? 1.0 : glm::dot(patch.centre, patch.centre));
  if (largest(power) <= 0) return {.visible = dvec3(0)};
  const dvec3 facing = glm::normalize(glm::cross(patch.u, patch.v));
  const auto all = even(question);
  std::array<Question::Place, kPacket> rays;
  return estimate(
      sampling, patch, !all,
      [&](std::span<const glm::dvec2> places, std::span<dvec3> values, std::span<dvec3> full) {
        std::array<size_t, kPacket> asked;
        size_t count = 0;
        for (size_t i = 0; i < places.size(); ++i) {
          const RayScene::Target at = question.at(places[i]);
          full[i] = values[i] = dvec3(0);
          if (!(glm::dot(point.normal, at.toward) > 0)) continue;
          const double d2 = glm::dot(at.toward, at.toward), d = std::sqrt(d2);
          full[i] = power * reflection(at.toward / d) *
                    (std::abs(glm::dot(facing, at.toward)) / (d * d2));
          values[i] = full[i] * all.value_or(dvec3(0));
          if (all || !(largest(full[i]) > 0)) continue;
          rays[count].target = at;
          asked[count++] = i;
        }
        question.pass(std::span(rays).first(count));
        for (size_t r = 0; r < count; ++r) values[asked[r]] = full[asked[r]] * rays[r].passed;
      });
}

}  // namespace sb
