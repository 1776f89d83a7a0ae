// What a scene calls for, seen through its camera: the input of every plan (design, section 3).
// Computed once per scene by suites/scenes (analysis), never by a technique.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

/// An ability that a scene may call for and a technique may represent, and the pass, buffer, branch
/// or sample that goes with it.
enum class Effect : uint8_t {
  OpaqueCasters,         ///< an opaque surface may throw a shadow into the view
  PerforatedCasters,     ///< alpha-masked casters: discard in the light pass
  TranslucentCasters,    ///< casters with 0 < tau < 1 somewhere
  ColouredTransmission,  ///< translucent casters whose t differs between channels
  TexturedTransmission,  ///< translucent casters whose alpha or t varies over the surface
  TranslucentReceivers,  ///< translucent surfaces in the view receive shadows
  TranslucentOverlap,    ///< a translucent receiver lies in another translucent caster's shadow
  AreaLights,            ///< a light with an extent
  ParticipatingMedia,    ///< a medium in view or between a light and the view
  MultipleLights,        ///< more than one light touches the view
  LocalLights,           ///< point or spot lights touch the view
  CameraTransparency,    ///< translucent surfaces in the view
  CameraLayers,          ///< ... which may overlap one another in the picture (order matters)
  ColouredTransparency,  ///< ... of which some are glass: what lies behind is weighted by channel
  NormalMaps,            ///< a visible material has one
  Emission,              ///< a visible material emits or is unlit
  Count
};
std::string_view effectName(Effect effect);         ///< "translucent-casters"
constexpr size_t kEffectCount = size_t(Effect::Count);

/// A small set of effects.
class EffectSet {
 public:
  constexpr EffectSet() = default;
  constexpr EffectSet(std::initializer_list<Effect> effects) {
    for (Effect e : effects) add(e);
  }
  constexpr void add(Effect e) { m_bits |= bit(e); }
  constexpr void remove(Effect e) { m_bits &= ~bit(e); }
  constexpr bool has(Effect e) const { return (m_bits & bit(e)) != 0; }
  constexpr EffectSet operator|(EffectSet o) const { return EffectSet(m_bits | o.m_bits); }
  constexpr EffectSet operator&(EffectSet o) const { return EffectSet(m_bits & o.m_bits); }
  constexpr EffectSet operator-(EffectSet o) const { return EffectSet(m_bits & ~o.m_bits); }
  constexpr bool operator==(const EffectSet&) const = default;
  constexpr bool empty() const { return m_bits == 0; }
  std::vector<Effect> list() const;

 private:
  constexpr explicit EffectSet(uint32_t bits) : m_bits(bits) {}
  static constexpr uint32_t bit(Effect e) { return 1u << uint32_t(e); }
  uint32_t m_bits = 0;
};

/// What one light may do to the view. Lists hold indices into Scene::instances, in scene order,
/// culled conservatively: what is left out cannot change a pixel.
struct LightEffects {
  uint32_t light = 0;                    ///< index into Scene::lights
  bool touchesView = false;              ///< false: no GPU work at all for this light
  std::vector<uint32_t> opaqueCasters;
  std::vector<uint32_t> perforatedCasters;
  std::vector<uint32_t> translucentCasters;
  std::vector<uint32_t> media;  ///< into Scene::media: may dim the light on its way to the view
  double penumbra = 0;  ///< no penumbra is wider, in heights of the picture; 0: all are hard
  bool casts() const {
    return touchesView &&
           !(opaqueCasters.empty() && perforatedCasters.empty() && translucentCasters.empty());
  }
};

/// What one camera shows and what lights may do to it.
struct ViewEffects {
  std::vector<LightEffects> lights;      ///< one per Scene::lights entry, in order
  std::vector<uint32_t> visibleOpaque;       ///< instances in the frustum, seen as opaque or masked
  std::vector<uint32_t> visibleTranslucent;  ///< instances the camera sees through
  std::vector<uint32_t> visibleMedia;        ///< into Scene::media: before the camera
};

/// The analysis of scene + camera + lights. Of a scene that moves: what any step of its path shows
/// or calls for. Of a camera that is set freely: what any place of it may show or call for.
struct Effects : ViewEffects {
  EffectSet present;
  std::map<Effect, std::string> reason;  ///< of each effect, present or not: why, for people
  std::vector<ViewEffects> steps;        ///< what each step of Scene::path shows; empty: no path
  /// The camera is set freely (SceneView::look). This one sees all of the scene at once: what is
  /// prepared for it serves every other.
  std::optional<Camera> overview;
};

}  // namespace sb
