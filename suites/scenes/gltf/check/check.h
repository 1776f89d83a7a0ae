// Checks of glTF's JSON before anything reads it: types, ranges and references by a table of rules
// (checkGltf), then that data fits where it says it lies and that nodes form trees.
#pragma once

#include "suites/scenes/gltf/source/source.h"

namespace sb {

/// Throws InputError naming the first field that is wrong. Afterwards every property in the table
/// has its type and range and every reference resolves; integers written as floats ("2.0") have
/// become integers. What cannot change the picture is a warning (see EXTRAS.md, "Broken files").
void checkGltf(GltfSource& source);

/// `value` as an index into the top-level array `target`: for what is checked where it is used alone
/// (skins, animations, morph targets). Throws InputError naming `field`.
size_t checkedIndex(const GltfSource& source, const nlohmann::json& value, const std::string& field,
                    const char* target);

/// Second half of checkGltf: numbers of things, bufferViews within buffers, accessors within
/// bufferViews, versions, required extensions, node trees.
void checkLayout(GltfSource& source);

/// Before all else: a glTF 1.0 file is named as such, not by the first thing that differs.
void refuseOldVersions(const GltfSource& source);
/// Versions other than 2.0. extensionsRequired: what is read, what can be left out with a warning,
/// what is refused.
void checkAsset(GltfSource& source);
void checkExtensions(GltfSource& source);

/// Bytes of one element of an accessor (matrix columns start on multiples of 4), 0 if unknown.
size_t elementBytes(int componentType, const std::string& type);

}  // namespace sb
