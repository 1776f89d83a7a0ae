// The ray-traced truth of a scene (spec 16): what every technique is measured against. Visibility
// of each light at the layers of decision D10, the shaded image, and where the truth jumps. Double
// precision throughout, relative to the eye; exact for lights without extent, sampled to a stated
// standard error in the penumbrae of others.
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
  /// cone); else all 0: nobody asks for visibility there. So too within a light, where visibility
  /// is undefined (the picture takes 1).
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
  /// Linear RGBA, alpha 1. What media scatter is right to a thousandth (suites/truth/media/media.h).
  std::vector<float> image;
  std::vector<uint8_t> imageEdges;  ///< union of all edges
  /// Largest standard error of visibility, of any channel, pixel, layer and light; 0: exact.
  double standardError = 0;
  uint64_t rays = 0;                ///< camera and shadow rays of everything above
  double seconds = 0;               ///< wall time of tracing, BVH included
};

/// How lights with an extent are sampled. Enters the key of a truth on disk.
struct AreaSampling {
  uint32_t first = 256;   ///< samples to begin with: 16 scrambles of a power of two of points
  uint32_t most = 65536;  ///< doubled up to these, no more than 65536
  double error = 5e-4;    ///< until the standard error of each channel is below
  /// Not 0: that many rays a light (a power of two) in a fixed pattern, whatever the error is.
  uint32_t pattern = 0;
  /// The picture takes radiance from all over the light instead of from its centre (spec 16,
  /// E-mode: f_r L_e T cos cos / d^2 over the light), each integral to `error` of what it would be
  /// without shadows. Visibility stays what it is.
  bool integrated = false;
};

struct TruthSettings {
  uint32_t width = 512;
  uint32_t height = 512;
  AreaSampling sampling = {};
  unsigned threads = 0;  ///< 0: all of the machine. The result does not depend on it, bit for bit
  const std::atomic<bool>* interrupted = nullptr;  ///< polled: true gives up
  std::function<void(double)> progress;            ///< done, 0..1
};

}  // namespace sb
