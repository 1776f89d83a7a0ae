// The lights fitted to what the camera shows now, each light view in the place that it has among
// all that any step, or any camera that is set freely, may ask for.
#pragma once

#include <optional>
#include <span>

#include "techniques/draw/fit/light_views.h"

namespace sb {

class ViewFit {
 public:
  /// Where everything is at one step, and what is shown there.
  struct Step {
    PlacedScene placed;
    const ViewEffects& shown;
  };

  /// `anyCamera`: the steps are seen by an overview, and every view may have every caster of its
  /// light.
  ViewFit(double aspect, bool anyCamera) : m_aspect(aspect), m_anyCamera(anyCamera) {}

  /// Fits the lights of all steps, and from now on of every other. Shows all at once.
  void prepare(const LightFitSettings& settings, std::span<const Step> steps);
  /// Of the shadow maps. Only where a technique has asked for light views.
  const LightFitSettings& settings() const { return *m_settings; }

  /// Fits the lights to `step`.
  void fit(const Step& step);
  /// The same while preparing: with every caster that a view may have there.
  void fitWidely(const Step& step);
  /// The views of all steps at once.
  void showAll() { m_views = m_united; }

  const std::vector<LightView>& views() const { return m_views; }
  size_t places() const { return m_united.size(); }
  /// Every view that ever has casters has some at the first step, and at each that may come first.
  bool firstHasAll() const { return m_firstHasAll; }

 private:
  std::vector<LightView> fitted(const Step& step) const;
  /// What a view may have at a step, for preparing.
  std::vector<LightView> fittedWidely(const Step& step) const;

  double m_aspect;
  bool m_anyCamera;
  std::optional<LightFitSettings> m_settings;
  std::vector<LightView> m_united;  ///< of all steps
  std::vector<LightView> m_views;
  bool m_firstHasAll = true;
};

}  // namespace sb
