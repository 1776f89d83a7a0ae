#include "suites/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sb {
namespace {

using Color = std::array<double, 3>;
using Plane = std::vector<float>;
using Kernel = std::vector<float>;  ///< odd width

// Constants of the paper, section 4.
constexpr double kQc = 0.7, kPc = 0.4, kPt = 0.95;  // colour difference
constexpr double kQf = 0.5, kFeatureWidth = 0.082;  // feature difference; width in degrees
/// Contrast sensitivity: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
struct Gauss {
  double a, b;
};
constexpr Gauss kSensitivityY = {1, 0.0047}, kSensitivityX = {1, 0.0053};
constexpr Gauss kSensitivityZ[2] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidestB = 0.04;

constexpr double kToXyz[3][3] = {{0.4123907993, 0.3575843394, 0.1804807884},
                                 {0.2126390059, 0.7151686788, 0.0721923154},
                                 {0.0193308187, 0.1191947798, 0.9505321522}};
constexpr double kToRgb[3][3] = {{3.2409699419, -1.5373831776, -0.4986107603},
                                 {-0.9692436363, 1.8759675015, 0.0415550574},
                                 {0.0556300797, -0.2039769589, 1.0569715142}};

Color times(const double (&m)[3][3], const Color& v) {
  Color out{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) out[r] += m[r][c] * v[c];
  return out;
}

const Color& white() {
  static const Color kWhite = times(kToXyz, {1, 1, 1});
  return kWhite;
}

/// Linear, relative to white: Y' Cx Cz.
Color toOpponent(const Color& rgb) {
  Color v = times(kToXyz, rgb);
  for (size_t c = 0; c < 3; ++c) v[c] /= white()[c];
  return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

Color fromOpponent(const Color& o) {
  const double y = (o[0] + 16) / 116;
  Color v = {o[1] / 500 + y, y, y - o[2] / 200};
  for (size_t c = 0; c < 3; ++c) v[c] *= white()[c];
  return times(kToRgb, v);
}

/// CIELAB with Hunt's adjustment: what is dark shows less colour.
Color toHuntLab(const Color& rgb) {
  Color v = times(kToXyz, rgb);
  constexpr double kDelta = 6.0 / 29;
  for (size_t c = 0; c < 3; ++c) {
    const double t = v[c] / white()[c];
    v[c] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  }
  const double l = 116 * v[1] - 16;
  return {l, 0.01 * l * 500 * (v[0] - v[1]), 0.01 * l * 200 * (v[1] - v[2])};
}

double hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// Colour difference to [0,1]: most of the range for small ones.
double redistributed(double difference) {
  static const double kMost =
      std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), kQc);
  const double power = std::pow(difference, kQc), knee = kPc * kMost;
  if (power < knee) return kPt / knee * power;
  return std::min(1.0, kPt + (power - knee) / (kMost - knee) * (1 - kPt));
}

int clampedIndex(int i, int count) { return std::clamp(i, 0, count - 1); }

/// Rows by `across`, then columns by `down`; beyond the border its value goes on.
Plane filtered(const Plane& in, int width, int height, const Kernel& across, const Kernel& down) {
  const int rx = int(across.size() / 2), ry = int(down.size() / 2);
  Plane rows(in.size(), 0.0f), out(in.size(), 0.0f);
  std::vector<float> padded(size_t(width + 2 * rx));
  for (int y = 0; y < height; ++y) {
    const float* line = in.data() + size_t(y) * size_t(width);
    for (int x = -rx; x < width + rx; ++x) padded[size_t(x + rx)] = line[clampedIndex(x, width)];
    float* result = rows.data() + size_t(y) * size_t(width);
    for (size_t k = 0; k < across.size(); ++k)
      for (int x = 0; x < width; ++x) result[x] += across[k] * padded[size_t(x) + k];
  }
  for (int y = 0; y < height; ++y) {
    float* result = out.data() + size_t(y) * size_t(width);
    for (int k = -ry; k <= ry; ++k) {
      const float* line = rows.data() + size_t(clampedIndex(y + k, height)) * size_t(width);
      const float weight = down[size_t(k + ry)];
      for (int x = 0; x < width; ++x) result[x] += weight * line[x];
    }
  }
  return out;
}

template <class Function>
Kernel kernelOf(int radius, const Function& value) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(float(value(double(i))));
  return kernel;
}

/// Positive weights sum to 1, negative ones to -1.
void normalise(Kernel& kernel) {
  double positive = 0, negative = 0;
  for (const float w : kernel) (w > 0 ? positive : negative) += double(w);
  for (float& w : kernel) w = float(w > 0 ? w / positive : w < 0 ? -w / negative : 0);
}

struct Opponents {
  Plane y, x, z;
};

Opponents opponentsOf(const report::Picture& picture) {
  Opponents o;
  for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    Color rgb;
    for (size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(double(picture.rgba[i + c]), 0.0, 1.0);
    const Color v = toOpponent(rgb);
    o.y.push_back(float(v[0]));
    o.x.push_back(float(v[1]));
    o.z.push_back(float(v[2]));
  }
  return o;
}

/// What the eye resolves of the picture.
Opponents seen(const Opponents& in, int width, int height, double pixelsPerDegree) {
  const double pi = std::numbers::pi;
  const int radius = int(std::ceil(3 * std::sqrt(kWidestB / (2 * pi * pi)) * pixelsPerDegree));
  auto gauss = [&](const Gauss& g, double& sum) {
    Kernel k = kernelOf(radius, [&](double i) {
      const double x = i / pixelsPerDegree;
      return std::exp(-pi * pi * x * x / g.b);
    });
    sum = 0;
    for (const float w : k) sum += double(w);
    for (float& w : k) w = float(w / sum);
    return k;
  };
  auto blurred = [&](const Plane& plane, const Gauss& g, double& weight) {
    double sum = 0;
    const Kernel k = gauss(g, sum);
    // Of the two-dimensional kernel before it is normalised.
    weight = g.a * std::sqrt(pi / g.b) * sum * sum;
    return filtered(plane, width, height, k, k);
  };
  double unused = 0, first = 0, second = 0;
  Opponents out{.y = blurred(in.y, kSensitivityY, unused),
                .x = blurred(in.x, kSensitivityX, unused),
                .z = blurred(in.z, kSensitivityZ[0], first)};
  const Plane narrow = blurred(in.z, kSensitivityZ[1], second);
  for (size_t i = 0; i < out.z.size(); ++i)
    out.z[i] = float((first * out.z[i] + second * narrow[i]) / (first + second));
  return out;
}

struct Features {
  Plane edges, points;
};

Features featuresOf(const Opponents& in, int width, int height, double pixelsPerDegree) {
  const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
  const int radius = int(std::ceil(3 * sigma));
  const auto bell = [&](double i) { return std::exp(-i * i / (2 * sigma * sigma)); };
  Kernel smooth = kernelOf(radius, bell);
  Kernel slope = kernelOf(radius, [&](double i) { return -i * bell(i); });
  Kernel bend = kernelOf(radius, [&](double i) { return (i * i / (sigma * sigma) - 1) * bell(i); });
  for (Kernel* k : {&smooth, &slope, &bend}) normalise(*k);
  Plane y = in.y;
  for (float& v : y) v = (v + 16) / 116;
  auto magnitude = [&](const Kernel& k) {
    Plane a = filtered(y, width, height, k, smooth);
    const Plane b = filtered(y, width, height, smooth, k);
    for (size_t i = 0; i < a.size(); ++i) a[i] = std::hypot(a[i], b[i]);
    return a;
  };
  return {magnitude(slope), magnitude(bend)};
}

Color labOf(const Opponents& o, size_t i) {
  Color rgb = fromOpponent({o.y[i], o.x[i], o.z[i]});
  for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
  return toHuntLab(rgb);
}

}  // namespace

std::vector<float> flip(const report::Picture& measured, const report::Picture& truth,
                        double pixelsPerDegree) {
  if (measured.width != truth.width || measured.height != truth.height)
    throw std::invalid_argument("pictures to compare differ in size");
  const int w = int(truth.width), h = int(truth.height);
  const Opponents a = opponentsOf(measured), b = opponentsOf(truth);
  const Opponents seenA = seen(a, w, h, pixelsPerDegree), seenB = seen(b, w, h, pixelsPerDegree);
  const Features fa = featuresOf(a, w, h, pixelsPerDegree), fb = featuresOf(b, w, h, pixelsPerDegree);
  std::vector<float> result(a.y.size());
  for (size_t i = 0; i < result.size(); ++i) {
    const double color = redistributed(hyab(labOf(seenA, i), labOf(seenB, i)));
    const double feature = std::max(std::abs(fa.edges[i] - fb.edges[i]),
                                    std::abs(fa.points[i] - fb.points[i]));
    const double structure = std::min(1.0, std::pow(feature / std::numbers::sqrt2, kQf));
    result[i] = float(std::pow(color, 1 - structure));
  }
  return result;
}

}  // namespace sb
