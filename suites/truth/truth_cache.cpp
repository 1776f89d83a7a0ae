#include "suites/truth/truth_cache.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/number.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

/// Changes whenever a truth of the same scene may come out differently.
constexpr uint32_t kVersion = 4;
constexpr char kMagic[8] = {'s', 'b', 't', 'r', 'u', 't', 'h', '\n'};
constexpr const char* kExtension = ".truth";

/// FNV-1a, 64 bits.
uint64_t hashOf(std::string_view bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ uint8_t(c)) * 0x100000001b3u;
  return hash;
}

class Writer {
 public:
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    m_bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  template <class T>
  void list(const std::vector<T>& values) {
    value(uint64_t(values.size()));
    m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  template <class T>
  void lists(const std::vector<std::vector<T>>& all) {
    value(uint64_t(all.size()));
    for (const auto& values : all) list(values);
  }
  std::string take() { return std::move(m_bytes); }

 private:
  std::string m_bytes;
};

/// Gives up at the first thing that does not fit.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : m_rest(bytes) {}
  template <class T>
  bool value(T& v) {
    if (m_rest.size() < sizeof v) return false;
    std::memcpy(&v, m_rest.data(), sizeof v);
    m_rest.remove_prefix(sizeof v);
    return true;
  }
  template <class T>
  bool list(std::vector<T>& values, uint64_t expected) {
    uint64_t count = 0;
    if (!value(count) || count != expected || m_rest.size() / sizeof(T) < count) return false;
    values.resize(count);
    std::memcpy(values.data(), m_rest.data(), count * sizeof(T));
    m_rest.remove_prefix(count * sizeof(T));
    return true;
  }
  template <class T>
  bool lists(std::vector<std::vector<T>>& all, uint64_t each) {
    uint64_t count = 0;
    if (!value(count) || count > m_rest.size()) return false;
    all.resize(count);
    for (auto& values : all)
      if (!list(values, each)) return false;
    return true;
  }
  bool atEnd() const { return m_rest.empty(); }

 private:
  std::string_view m_rest;
};

std::string payloadOf(const Truth& t) {
  Writer out;
  out.value(t.width);
  out.value(t.height);
  out.value(t.standardError);
  out.value(t.rays);
  out.value(t.seconds);
  out.list(t.image);
  out.list(t.imageEdges);
  out.lists(t.visibility);
  out.lists(t.edges);
  out.lists(t.reflected);
  out.lists(t.surfaces);
  // Truths of scenes without media keep their bytes.
  if (!t.mediaVisibility.empty()) {
    out.lists(t.mediaVisibility);
    out.lists(t.mediaEdges);
  }
  return out.take();
}

bool parse(std::string_view payload, Truth& t) {
  Reader in(payload);
  if (!in.value(t.width) || !in.value(t.height) || !in.value(t.standardError) ||
      !in.value(t.rays) || !in.value(t.seconds))
    return false;
  const uint64_t pixels = uint64_t(t.width) * t.height;
  return in.list(t.image, 4 * pixels) && in.list(t.imageEdges, pixels) &&
         in.lists(t.visibility, 4 * pixels) && in.lists(t.edges, pixels) &&
         in.lists(t.reflected, pixels) && in.lists(t.surfaces, pixels) &&
         (in.atEnd() ||
          (in.lists(t.mediaVisibility, 4 * pixels) && in.lists(t.mediaEdges, pixels) &&
           in.atEnd() && t.mediaVisibility.size() * kTruthLayers == t.visibility.size() &&
           t.mediaEdges.size() == t.mediaVisibility.size())) &&
         t.surfaces.size() == kTruthLayers && t.visibility.size() == t.edges.size() &&
         t.visibility.size() == t.reflected.size() && t.visibility.size() % kTruthLayers == 0;
}

std::string headerOf(const std::string& key, std::string_view payload) {
  Writer out;
  out.value(kMagic);
  out.value(kVersion);
  out.value(hashOf(key));
  out.value(uint64_t(payload.size()));
  out.value(hashOf(payload));
  return out.take();
}

template <class Visit>
CacheUse forEachFile(const fs::path& folder, const Visit& visit) {
  CacheUse use;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    // What a killed process left is named after the file it was to become.
    const std::string name = entry.path().filename();
    if (name.find(kExtension) == name.npos || !entry.is_regular_file(error)) continue;
    const uint64_t bytes = entry.file_size(error);
    if (error || !visit(entry.path())) continue;
    ++use.files;
    use.bytes += bytes;
  }
  return use;
}

}  // namespace

fs::path truthCacheFolder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  fs::path base = cache && *cache == '/'  ? fs::path(cache)
                  : home && *home == '/' ? fs::path(home) / ".cache"
                                         : fs::temp_directory_path();
  return base / "shadowbench" / "truth";
}

std::string truthKey(const std::string& sceneHash, uint32_t width, uint32_t height,
                     const AreaSampling& sampling) {
  return sceneHash + "-" + std::to_string(width) + "x" + std::to_string(height) + "-s" +
         std::to_string(sampling.first) + "-" + std::to_string(sampling.most) + "-" +
         base::numberText(sampling.error) + "-" + std::to_string(sampling.pattern) +
         (sampling.integrated ? "e" : "") + "-v" + std::to_string(kVersion);
}

std::optional<Truth> readTruth(const fs::path& folder, const std::string& key) {
  std::ifstream in(folder / (key + kExtension), std::ios::binary);
  if (!in) return {};
  std::ostringstream text;
  text << in.rdbuf();
  const std::string bytes = std::move(text).str();
  const size_t header = headerOf(key, "").size();
  if (bytes.size() < header) return {};
  const std::string_view payload = std::string_view(bytes).substr(header);
  if (std::string_view(bytes).substr(0, header) != headerOf(key, payload)) return {};
  Truth truth;
  if (!parse(payload, truth)) return {};
  return truth;
}

bool writeTruth(const fs::path& folder, const std::string& key, const Truth& truth) {
  static std::atomic<uint32_t> counter = 0;
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path target = folder / (key + kExtension);
  fs::path temporary = target;
  temporary += "." + std::to_string(getpid()) + "-" + std::to_string(counter++);
  {
    std::ofstream out(temporary, std::ios::binary);
    const std::string payload = payloadOf(truth);
    const std::string header = headerOf(key, payload);
    out.write(header.data(), std::streamsize(header.size()));
    out.write(payload.data(), std::streamsize(payload.size()));
    out.flush();
    if (!out) {
      out.close();
      fs::remove(temporary, error);
      return false;
    }
  }
  fs::rename(temporary, target, error);
  if (!error) return true;
  fs::remove(temporary, error);
  return false;
}

CacheUse cacheUse(const fs::path& folder) {
  return forEachFile(folder, [](const fs::path&) { return true; });
}

CacheUse clearCache(const fs::path& folder) {
  return forEachFile(folder, [](const fs::path& file) {
    std::error_code error;
    return fs::remove(file, error);
  });
}

}  // namespace sb
