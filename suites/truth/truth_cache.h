// Truths on disk, so that each is traced once. One file a truth, named by a hash of everything that
// enters it; written beside and renamed, checked by length and checksum when read: a file that is
// truncated, of another version or of another truth counts as absent.
#pragma once

#include <filesystem>
#include <optional>

#include "suites/truth/truth.h"

namespace sb {

/// $XDG_CACHE_HOME/shadowbench/truth, else ~/.cache/shadowbench/truth, else a folder under /tmp.
std::filesystem::path truthCacheFolder();

/// Name of a truth: `sceneHash` stands for geometry, materials, lights and camera; how it is
/// sampled and the tracer's version enter too.
std::string truthKey(const std::string& sceneHash, uint32_t width, uint32_t height,
                     const AreaSampling& sampling = {});

std::optional<Truth> readTruth(const std::filesystem::path& folder, const std::string& key);
/// Failure to write is no failure of the run: false, and nothing is left behind.
bool writeTruth(const std::filesystem::path& folder, const std::string& key, const Truth& truth);

struct CacheUse {
  uint64_t files = 0;
  uint64_t bytes = 0;
};
CacheUse cacheUse(const std::filesystem::path& folder);
/// Removes what this program wrote there, nothing else.
CacheUse clearCache(const std::filesystem::path& folder);

}  // namespace sb
