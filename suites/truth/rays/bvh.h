// Which triangles a ray meets (decision D7): a tree of boxes that Embree built. Boxes are rounded
// outward and widened by what turning a ray into floats can move it, so the tree never hides a
// triangle that testing all of them would find; the test itself is ours and in double.
#pragma once

#include <array>
#include <functional>
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
  /// In a packet, a triangle that blocks it for sure (Bvh) stops it without being judged. tMin is
  /// 0.
  bool stopsUnasked = false;
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
  /// except to infinity. `heights`: of each triangle that blocks rays, how far from its plane both
  /// ends of a ray have to lie (world units) for it to do so unasked; infinity, or no heights: it
  /// is always asked. Throws std::runtime_error when Embree refuses.
  Bvh(const std::vector<TruthTriangle>& triangles, double reach,
      const std::vector<double>& heights = {});

  /// What to do with a hit: pass through it, keep it, keep it and forget all behind it, or end the
  /// search with it.
  enum class Verdict { Ignore, Keep, Nearest, Stop };
  using Judge = std::function<Verdict(const TruthHit&)>;
  /// Hits in order of t, ties by triangle. The order in which `judge` is asked is not defined;
  /// after Stop the result is that one hit. `walks` change no answer.
  void hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
            const BoxWalks& walks = bestWalks()) const;
  /// The same of many rays: cheaper where those that follow one another run side by side (kPacket
  /// walk together). `Rays` has
  ///   TruthRay ray(size_t i) const;
  ///   Verdict judge(size_t i, const TruthHit& hit);
  ///   void end(size_t i, bool stopped, std::vector<TruthHit>& hits);
  /// `end` is called once for each, with its hits, to be kept by swapping; those of a ray that was
  /// stopped mean nothing. In suites/truth/rays/ray_packet.h.
  using PacketHits = std::array<std::vector<TruthHit>, kPacket>;
  template <class Rays>
  void hits(size_t count, Rays& rays, PacketHits& scratch,
            const BoxWalks& walks = bestWalks()) const;

  /// Memory of the tree.
  uint64_t bytes() const { return m_tree.bytes(); }

  /// The same by testing every triangle.
  static void hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                        const Judge& judge, std::vector<TruthHit>& out);

 private:
  Bvh(const std::vector<TruthTriangle>& triangles, const std::vector<double>& heights,
      double extent);
  template <class Rays>
  friend class RayPacket;

  const std::vector<TruthTriangle>& m_triangles;
  BoxTree m_tree;
};

}  // namespace sb
