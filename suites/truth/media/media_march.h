// The march of one ray through media: what they scatter back along it (suites/truth/media/media.h).
#pragma once

#include <deque>

#include "suites/truth/media/media.h"

namespace sb {

class MediaMarch {
 public:
  /// Both must outlive the march.
  MediaMarch(const MediaField::Way& way, const MediaField::Lights& lights);

  /// As it is, in about so many steps.
  MediaField::Passage inSteps(uint32_t steps);
  /// Extrapolated from steps that are halved as need be.
  glm::dvec3 light();

 private:
  /// A place on the ray; its lights are asked for once, when a step that scatters needs them.
  struct Node {
    double at;
    bool asked = false;
    std::vector<MediaField::Arrival> lights = {};
  };
  struct Step {
    Node *from, *middle, *to;
    /// Of each span: optical depth times albedo, times the share of the step's depth that is taken
    /// out of the ray: what it scatters of a light of 1 from everywhere.
    std::array<glm::dvec3, kMaxMedia> scattered;
    bool scatters = false;
    glm::dvec3 depth = glm::dvec3(0);  ///< optical
    glm::dvec3 transmittance = glm::dvec3(1);
    glm::dvec3 light = glm::dvec3(0);       ///< by what arrives at its middle
    glm::dvec3 unshadowed = glm::dvec3(0);  ///< ... and would without occlusion
  };

  Node* node(double at) { return &m_nodes.emplace_back(Node{at}); }
  Step step(Node* from, Node* to);
  std::vector<Step> steps(uint32_t count);
  /// What a step scatters by the lights of a node.
  glm::dvec3 lightOf(const Step& step, Node& node, bool shadowed = true);
  /// How far the lights at its ends are from lying in a line with that at its middle.
  glm::dvec3 bend(const Step& step);
  bool swallows(const Step& step) const;
  void add(const Step& whole, double allowed, int halved);

  const MediaField::Way m_way;
  const MediaField::Lights& m_lights;
  double m_first, m_last;  ///< ends of the way through boxes
  std::deque<Node> m_nodes;
  glm::dvec3 m_light = glm::dvec3(0);
  glm::dvec3 m_through = glm::dvec3(1);
};

}  // namespace sb
