// Changes to glTF files that get past a parser: of JSON values by their structure, of packed and
// plain data by their bytes, of the container, and blind ones.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace sb::fuzz {

using Random = std::mt19937_64;

/// `seed`, changed once to a few times; parts of `other` may get into it.
std::string mutated(const std::string& seed, const std::string& other, Random& random);

/// The same file as a container: the first buffer's data uri becomes the binary chunk.
std::string asGlb(const std::string& gltf);

}  // namespace sb::fuzz
