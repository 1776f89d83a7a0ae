// A medium as shaders see it, and its density as the truth sees it (spec 14).
#pragma once

#include <span>

#include "shaders/common/shared_medium.h"
#include "techniques/scene/scene.h"

namespace sb {

inline constexpr size_t kMaxMedia = MAX_MEDIA;

/// Density where none is greater.
double greatestDensity(const Medium& medium);
/// What of a medium is too thin to change a picture: sigma_t times the box's longest way.
inline constexpr double kThinnest = 1e-4;
/// Optical depth that no ray through the box exceeds, of the densest channel.
double greatestDepth(const Medium& medium);

/// World relative to `eye` -> unit cube. The box must have a volume.
glm::dmat4 toBox(const Medium& medium, const glm::dvec3& eye);

/// Of a medium of kind Smoke.
gpu::SmokeShape smokeShape(const Medium& medium);
/// Of a medium of kind Grid, at a place in its unit cube.
double gridDensity(const Medium& medium, const glm::dvec3& place);

/// The record of shaders, relative to `eye`. A grid's densities are not in it.
gpu::MediumData mediumData(const Medium& medium, const glm::dvec3& eye);
/// The uniform block of at most kMaxMedia media.
gpu::MediaBlock mediaBlock(std::span<const Medium> media, const glm::dvec3& eye);

}  // namespace sb
