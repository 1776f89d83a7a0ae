#include "techniques/draw/fit/view_fit.h"

#include <algorithm>

#include "techniques/draw/fit/view_path.h"

namespace sb {

void ViewFit::prepare(const LightFitSettings& settings, std::span<const Step> steps) {
  m_settings = settings;
  std::vector<std::vector<LightView>> views;
  for (const Step& step : steps) views.push_back(fittedWidely(step));
  m_views = m_united = uniteViews(views);
  const auto filled = [](const std::vector<LightView>& list) {
    return std::ranges::count_if(list, [](const LightView& v) { return !v.empty(); });
  };
  m_firstHasAll = !m_anyCamera && filled(views.front()) == filled(m_united);
}

void ViewFit::fit(const Step& step) {
  if (m_settings) m_views = placeViews(m_united, fitted(step));
}

void ViewFit::fitWidely(const Step& step) {
  if (m_settings) m_views = placeViews(m_united, fittedWidely(step));
}

std::vector<LightView> ViewFit::fitted(const Step& step) const {
  return fitLights(step.placed, step.shown, m_aspect, *m_settings);
}

std::vector<LightView> ViewFit::fittedWidely(const Step& step) const {
  std::vector<LightView> views = fitted(step);
  if (!m_anyCamera) return views;
  for (LightView& view : views) {
    const LightEffects& light = step.shown.lights[view.light];
    view.opaque = light.opaqueCasters;
    view.perforated = light.perforatedCasters;
    view.translucent = light.translucentCasters;
  }
  return views;
}

}  // namespace sb
