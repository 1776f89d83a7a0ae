// Which triangles a ray meets (decision D7): a tree of boxes that Embree built. Boxes are rounded
// outward and widened by what turning a ray into floats can move it, so the tree never hides a
// triangle that testing all of them would find; the test itself is ours and in double.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "suites/truth/rays/box_tree.h"

namespace sb {

struct TruthRay {
  glm::dvec3 origin;     ///< relative to the eye
  glm::dvec3 direction;  ///< of any length: t counts in it
  double tMin = 0;       ///< hits lie in (tMin, tMax)
  double tMax = 0;       ///< may be infinite
  double tie = 0;        ///< hits so little behind the nearest that ends the ray are kept too
  uint32_t own = kNone;  ///< the triangle it starts on, which it does not meet
};

struct TruthHit {
  double t = 0;
  double b = 0, c = 0;    ///< weights of the second and third corner
  uint32_t triangle = 0;  ///< index into the triangles
  bool front = false;     ///< by winding
};

class Bvh {
 public:
  /// `triangles` must outlive the tree; `reach`: no ray starts or ends farther from zero than this,
  /// except to infinity. Throws std::runtime_error when Embree refuses.
  Bvh(const std::vector<TruthTriangle>& triangles, double reach);

  /// What to do with a hit: pass through it, keep it, keep it and forget all behind it, or end the
  /// search with it.
  enum class Verdict { Ignore, Keep, Nearest, Stop };
  using Judge = std::function<Verdict(const TruthHit&)>;
  /// Hits in order of t, ties by triangle. The order in which `judge` is asked is not defined;
  /// after Stop the result is that one hit. `walks` change no answer.
  void hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
            const BoxWalks& walks = bestWalks()) const;
  /// The same of up to kPacket rays, told by their numbers: cheaper where they run side by side.
  using PacketJudge = std::function<Verdict(size_t ray, const TruthHit&)>;
  void hits(std::span<const TruthRay* const> rays, const PacketJudge& judge,
            std::span<std::vector<TruthHit>> out, const BoxWalks& walks = bestWalks()) const;

  /// Memory of the tree.
  uint64_t bytes() const { return m_tree.bytes(); }

  /// The same by testing every triangle.
  static void hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                        const Judge& judge, std::vector<TruthHit>& out);

 private:
  const std::vector<TruthTriangle>& m_triangles;
  double m_margin;  ///< world units
  BoxTree m_tree;
};

}  // namespace sb
