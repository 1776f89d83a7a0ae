// The ray-traced truth of a scene (spec 16): what every technique is measured against. Visibility of
// each light at the layers of decision D10, the shaded image, and where the truth jumps. Double
// precision throughout, relative to the eye; exact for lights without area, so nothing is sampled.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

/// Layers of visibility: 0 the first opaque surface, 1..4 from the eye (decision D10).
inline constexpr uint32_t kTruthLayers = 5;

/// All pictures: row 0 = bottom row, sample at the pixel's centre.
struct Truth {
  uint32_t width = 0;
  uint32_t height = 0;
  /// [light * kTruthLayers + layer], light an index into Scene::lights: width * height * 4 floats.
  /// RGB the share of the light that arrives, alpha 1 where a surface is and the light's radiance
  /// reaches the side that the camera sees (in front of the geometric normal, in range, in the
  /// cone); else all 0: nobody asks for visibility there.
  std::vector<std::vector<float>> visibility;
  /// Same index: 1 where a pixel lies within 2 px of a discontinuity of this layer or this
  /// visibility (the truth compared at five positions of a pixel).
  std::vector<std::vector<uint8_t>> edges;
  /// Same index, one float a pixel: luminance that the light would send from there to the eye if
  /// nothing shadowed it; 0 where nobody asks for visibility.
  std::vector<std::vector<float>> reflected;
  /// Per layer: 1 where a surface is, 2 where that surface is translucent to the light.
  std::vector<std::vector<uint8_t>> surfaces;
  /// By light, of scenes with media alone (else empty): as `visibility`, at the point in media of
  /// each pixel (MediaView::Point), alpha 1 where the light's radiance reaches it.
  std::vector<std::vector<float>> mediaVisibility;
  std::vector<std::vector<uint8_t>> mediaEdges;  ///< same index: where it jumps, as `edges`
  /// Linear RGBA, alpha 1. What media scatter is right to a thousandth (suites/truth/media.h).
  std::vector<float> image;
  std::vector<uint8_t> imageEdges;  ///< union of all edges
  double standardError = 0;         ///< of visibility; 0: exact
  uint64_t rays = 0;                ///< camera and shadow rays of everything above
  double seconds = 0;               ///< wall time of tracing, BVH included
};

struct TruthSettings {
  uint32_t width = 512;
  uint32_t height = 512;
  unsigned threads = 0;  ///< 0: all of the machine. The result does not depend on it, bit for bit
  const std::atomic<bool>* interrupted = nullptr;  ///< polled: true gives up
  std::function<void(double)> progress;            ///< done, 0..1
};

/// What of the scene the truth cannot show yet, for people; empty: it can be traced.
std::vector<std::string> notYetRepresented(const Scene& scene);

}  // namespace sb
