// Tracing a whole truth: centres for the values, four more positions a pixel for where it jumps.
#include "suites/truth/truth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <mutex>

#include "suites/truth/lights/sampler.h"

namespace sb {
namespace {

constexpr double kOffset = 0.35;       ///< of the four positions from the centre, pixels
constexpr double kCosTurn = 0.8660254; ///< of 30 degrees: a geometric normal that turns more jumps
constexpr double kJump = 1.0 / 64;     ///< of visibility
/// In a penumbra: what changes by less within half a pixel is a slope, not an edge. Narrower
/// penumbrae lie between positions that are exact.
constexpr double kSteep = 0.25;
/// Pixels that are traced together, a side: eight that follow one another are four by two, whose
/// rays stay closer together than those of a row.
constexpr uint32_t kTile = 8;
constexpr int kDilate = 2;             ///< pixels

/// Layer of the truth (0: first opaque) -> index into the sampler's layers, or none.
std::optional<size_t> indexOf(const Sampler& s, uint32_t layer) {
  if (layer == 0) return s.endsOpaque() ? std::optional(s.layers().size() - 1) : std::nullopt;
  return layer - 1 < s.layers().size() ? std::optional<size_t>(layer - 1) : std::nullopt;
}

bool surfaceJumps(const Sampler::Layer& a, const Sampler::Layer& b) {
  return a.point.instance != b.point.instance ||
         glm::dot(a.point.normal, b.point.normal) < kCosTurn;
}

/// Of layers, or of points in media.
template <class Asked>
bool visibilityJumps(const Asked& a, const Asked& b, uint32_t light) {
  if (a.asked[light] != b.asked[light]) return true;
  const LightVisibility::Answer &p = a.answers[light], &q = b.answers[light];
  if (p.undefined != q.undefined) return true;
  const double jump = p.sampled || q.sampled ? kSteep : kJump;
  return glm::any(glm::greaterThan(glm::abs(p.visible - q.visible), glm::dvec3(jump)));
}

class Tracing {
 public:
  Tracing(const RayScene& scene, const LightVisibility& lights, const TruthSettings& settings)
      : m_scene(scene), m_lights(lights), m_settings(settings), m_coarse(settings.sampling) {
    m_coarse.most = m_coarse.first;
    const size_t pixels = size_t(scene.width()) * scene.height();
    const size_t images = size_t(scene.lights()) * kTruthLayers;
    m_truth.width = scene.width();
    m_truth.height = scene.height();
    m_truth.visibility.assign(images, std::vector<float>(4 * pixels, 0.0f));
    m_truth.reflected.assign(images, std::vector<float>(pixels, 0.0f));
    m_truth.edges.assign(images, std::vector<uint8_t>(pixels, 0));
    m_truth.surfaces.assign(kTruthLayers, std::vector<uint8_t>(pixels, 0));
    if (!scene.media().empty()) {
      m_truth.mediaVisibility.assign(scene.lights(), std::vector<float>(4 * pixels, 0.0f));
      m_truth.mediaEdges.assign(scene.lights(), std::vector<uint8_t>(pixels, 0));
    }
    m_truth.image.assign(4 * pixels, 0.0f);
    m_truth.imageEdges.assign(pixels, 0);
  }

  std::optional<Truth> run() {
    const auto start = std::chrono::steady_clock::now();
    const uint32_t across = tilesAlong(m_scene.width());
    const uint32_t tiles = across * tilesAlong(m_scene.height());
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, tiles), [&](const auto& range) {
      Samplers samplers(m_scene, m_lights);
      for (uint32_t i = range.begin(); i < range.end() && !interrupted(); ++i) {
        const double worst = traceTile(i % across * kTile, i / across * kTile, samplers);
        tileDone(worst, tiles);
      }
      m_rays += samplers.rays();
    });
    if (interrupted()) return {};
    for (auto& mask : m_truth.edges) {
      dilate(mask);
      for (size_t i = 0; i < mask.size(); ++i) m_truth.imageEdges[i] |= mask[i];
    }
    for (auto& mask : m_truth.mediaEdges) dilate(mask);
    dilate(m_depthEdges);
    for (size_t i = 0; i < m_depthEdges.size(); ++i) m_truth.imageEdges[i] |= m_depthEdges[i];
    m_truth.rays = m_rays;
    m_truth.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(m_truth);
  }

 private:
  bool interrupted() const { return m_settings.interrupted && m_settings.interrupted->load(); }

  static uint32_t tilesAlong(uint32_t pixels) { return (pixels + kTile - 1) / kTile; }

  void tileDone(double worst, uint32_t of) {
    const uint32_t done = ++m_tiles;
    const std::lock_guard lock(m_tileDone);
    m_truth.standardError = std::max(m_truth.standardError, worst);
    if (m_settings.progress) m_settings.progress(double(done) / of);
  }

  /// Of a tile's pixels.
  struct Samplers {
    Samplers(const RayScene& scene, const LightVisibility& lights)
        : centres(kTile * kTile, Sampler(scene, lights)),
          beside(4 * kTile * kTile, Sampler(scene, lights)) {}
    uint64_t rays() const {
      uint64_t rays = 0;
      for (const Sampler& s : centres) rays += s.rays();
      for (const Sampler& s : beside) rays += s.rays();
      return rays;
    }
    std::vector<Sampler> centres, beside;  ///< one and four a pixel
  };

  /// From a corner on; what sticks out of the picture is left out. Gives the largest standard
  /// error.
  double traceTile(uint32_t x0, uint32_t y0, Samplers& samplers) {
    std::vector<size_t> pixels;
    std::vector<glm::dvec2> middles, corners;
    for (uint32_t i = 0; i < kTile * kTile; ++i) {
      // Bits of x and y in turn.
      const uint32_t x = x0 + (i & 1) + (i >> 1 & 2) + (i >> 2 & 4);
      const uint32_t y = y0 + (i >> 1 & 1) + (i >> 2 & 2) + (i >> 3 & 4);
      if (x >= m_scene.width() || y >= m_scene.height()) continue;
      pixels.push_back(size_t(y) * m_scene.width() + x);
      const glm::dvec2& middle = middles.emplace_back(x + 0.5, y + 0.5);
      for (uint32_t c = 0; c < 4; ++c)
        corners.push_back(middle +
                          glm::dvec2(c & 1 ? kOffset : -kOffset, c & 2 ? kOffset : -kOffset));
    }
    Sampler::find(std::span(samplers.centres).first(middles.size()), middles, m_settings.sampling);
    Sampler::find(std::span(samplers.beside).first(corners.size()), corners, m_coarse);
    double worst = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
      keep(samplers.centres[i], pixels[i], worst);
      for (size_t c = 0; c < 4; ++c)
        compare(samplers.centres[i], samplers.beside[4 * i + c], pixels[i]);
    }
    return worst;
  }

  /// `worst`: largest standard error so far.
  void keep(Sampler& centre, size_t pixel, double& worst) {
    const glm::vec3 color = centre.color();
    for (size_t c = 0; c < 3; ++c) m_truth.image[4 * pixel + c] = color[int(c)];
    m_truth.image[4 * pixel + 3] = 1;
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const auto index = indexOf(centre, layer);
      if (!index) continue;
      const Sampler::Layer& found = centre.layers()[*index];
      m_truth.surfaces[layer][pixel] = found.point.translucent ? 2 : 1;
      for (uint32_t l = 0; l < m_scene.lights(); ++l) {
        const LightVisibility::Answer& answer = found.answers[l];
        if (answer.undefined) m_depthEdges[pixel] = 1;
        if (!found.asked[l] || answer.undefined) continue;
        worst = std::max(worst, answer.error);
        float* out = m_truth.visibility[size_t(l) * kTruthLayers + layer].data() + 4 * pixel;
        for (int c = 0; c < 3; ++c) out[c] = float(answer.visible[c]);
        out[3] = 1;
        m_truth.reflected[size_t(l) * kTruthLayers + layer][pixel] = centre.reflected(*index, l);
      }
    }
    for (uint32_t l = 0; l < m_truth.mediaVisibility.size(); ++l) {
      const MediaView::Point& point = centre.media().point();
      const LightVisibility::Answer& answer = point.answers[l];
      if (!point.asked[l] || answer.undefined) continue;
      worst = std::max(worst, answer.error);
      float* out = m_truth.mediaVisibility[l].data() + 4 * pixel;
      for (int c = 0; c < 3; ++c) out[c] = float(answer.visible[c]);
      out[3] = 1;
    }
  }

  void compare(const Sampler& a, const Sampler& b, size_t pixel) {
    if (a.layers().size() != b.layers().size()) m_depthEdges[pixel] = 1;
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const auto i = indexOf(a, layer), j = indexOf(b, layer);
      if (!i && !j) continue;
      const bool jumps = !i || !j || surfaceJumps(a.layers()[*i], b.layers()[*j]);
      if (jumps) m_depthEdges[pixel] = 1;
      for (uint32_t l = 0; l < m_scene.lights(); ++l)
        if (jumps || visibilityJumps(a.layers()[*i], b.layers()[*j], l))
          m_truth.edges[size_t(l) * kTruthLayers + layer][pixel] = 1;
    }
    for (uint32_t l = 0; l < m_truth.mediaEdges.size(); ++l)
      if (visibilityJumps(a.media().point(), b.media().point(), l))
        m_truth.mediaEdges[l][pixel] = 1;
  }

  /// Grows a mask by kDilate pixels, corners included.
  void dilate(std::vector<uint8_t>& mask) const {
    const auto w = std::ptrdiff_t(m_scene.width()), size = std::ptrdiff_t(mask.size());
    // Whole rows are shifted onto one another; what would cross a row's end is not.
    const auto grow = [&](std::ptrdiff_t step, std::ptrdiff_t row) {
      const std::vector<uint8_t> old = mask;
      for (std::ptrdiff_t first = 0; first < size; first += row)
        for (std::ptrdiff_t k = -kDilate * step; k <= kDilate * step; k += step) {
          const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, -k);
          const std::ptrdiff_t end = std::min(row, row - k);
          for (std::ptrdiff_t i = begin; i < end; ++i)
            mask[size_t(first + i)] |= old[size_t(first + i + k)];
        }
    };
    grow(1, w);
    grow(w, size);
  }

  const RayScene& m_scene;
  const LightVisibility& m_lights;
  const TruthSettings& m_settings;
  AreaSampling m_coarse;  ///< beside the centres
  Truth m_truth;
  std::vector<uint8_t> m_depthEdges =
      std::vector<uint8_t>(size_t(m_scene.width()) * m_scene.height(), 0);
  std::atomic<uint64_t> m_rays = 0;
  std::atomic<uint32_t> m_tiles = 0;
  std::mutex m_tileDone;
};

}  // namespace

std::optional<Truth> traceTruth(const RayScene& scene, const LightVisibility& lights,
                                const TruthSettings& settings) {
  return Tracing(scene, lights, settings).run();
}

}  // namespace sb
