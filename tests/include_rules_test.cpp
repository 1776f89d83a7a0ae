// Who may include whom (design, section 1): folders below the root, and what each may see.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Longest matching folder counts. Every folder may include itself; an entry may name a file prefix.
const std::map<std::string, std::vector<std::string>> kAllowed = {
    {"base", {}},
    {"backends/rhi", {}},
    {"backends/shader", {"backends/rhi"}},
    {"backends/vulkan", {"backends/rhi", "backends/shader"}},
    {"backends/opengl", {"backends/rhi", "backends/shader"}},
    {"backends/null", {"backends/rhi", "backends/shader"}},
    {"reports", {}},
    {"reports/html/elements", {"reports/record.h", "reports/html/model.h", "reports/json"}},
    {"shaders/common", {}},
    {"techniques/scene", {"shaders/common/shared_"}},
    {"techniques/plan", {"techniques/scene"}},
    {"techniques/draw",
     {"techniques/scene", "techniques/plan", "backends/rhi", "shaders/common/shared_"}},
    {"techniques/draw/frame", {"backends/rhi"}},
    {"techniques/draw/scene", {"techniques/scene", "backends/rhi", "shaders/common/shared_"}},
    {"techniques/draw/fit", {"techniques/scene", "techniques/plan", "shaders/common/shared_"}},
    {"techniques/draw/views",
     {"techniques/draw/fit", "techniques/draw/scene", "techniques/scene", "techniques/plan",
      "backends/rhi", "shaders/common/shared_"}},
    {"techniques/render",
     {"techniques/scene", "techniques/plan", "techniques/draw", "backends/rhi",
      "shaders/common/shared_"}},
    // Families: none sees another, but for partitions, which are of the casters of maps.
    {"techniques/maps",
     {"techniques/scene", "techniques/plan", "techniques/draw", "techniques/render", "backends/rhi",
      "shaders/common/shared_"}},
    {"techniques/partition",
     {"techniques/scene", "techniques/plan", "techniques/draw", "techniques/render",
      "techniques/maps", "backends/rhi", "shaders/common/shared_"}},
    {"techniques/lists", {"backends/rhi", "shaders/common/shared_"}},
    {"techniques/volumes",
     {"techniques/scene", "techniques/plan", "techniques/draw", "techniques/render", "backends/rhi",
      "shaders/common/shared_"}},
    // Edges of meshes and bounds of volumes know no volume.
    {"techniques/volumes/edges", {"techniques/scene", "techniques/draw", "shaders/common/shared_"}},
    {"techniques/volumes/culling", {"techniques/scene", "techniques/draw", "backends/rhi"}},
    {"techniques/volumes/wedges",
     {"techniques/scene", "techniques/draw", "techniques/render", "techniques/volumes",
      "shaders/common/shared_"}},
    {"techniques/methods", {"techniques", "backends/rhi", "shaders/common/shared_"}},
    {"suites/scenes", {"techniques/scene", "techniques/plan"}},
    // What scenes are made of knows none of them.
    {"suites/scenes/procedural/parts",
     {"suites/scenes/edit", "suites/scenes/procedural/scenes.h", "techniques/scene"}},
    {"suites/truth", {"techniques/scene", "techniques/plan", "shaders/common/shared_"}},
    {"suites/metrics", {"reports"}},
    {"suites/harness",
     {"suites/scenes", "suites/truth", "suites/metrics", "techniques/scene", "techniques/plan",
      "techniques/draw", "techniques/render", "reports", "backends/rhi"}},
    {"suites/stability",
     {"suites/harness", "suites/scenes", "suites/truth", "suites/metrics", "techniques/scene",
      "techniques/plan", "techniques/draw", "techniques/render", "reports",
      "backends/rhi/memory_limit.h"}},
    {"suites/stability/cases",
     {"suites/stability", "suites/harness", "suites/scenes", "suites/truth", "suites/metrics",
      "techniques/scene", "techniques/plan", "techniques/draw", "techniques/render", "reports",
      "backends/rhi/memory_limit.h"}},
    {"suites/cli",
     {"suites/harness", "suites/stability", "suites/scenes", "suites/truth", "suites/metrics",
      "techniques/scene", "techniques/plan", "techniques/render", "reports", "backends/rhi",
      "backends/shader", "backends/vulkan/device/vk_backend.h",
      "backends/opengl/device/gl_backend.h", "backends/null/null_backend.h"}},
};

/// Headers of the graphics APIs, which only their backend may see.
const std::regex kApiHeader("vulkan|volk|GL/|EGL/|GLES|osmesa|epoxy", std::regex::icase);

const std::pair<const std::string, std::vector<std::string>>* ruleOf(const std::string& file) {
  const std::pair<const std::string, std::vector<std::string>>* best = nullptr;
  for (const auto& rule : kAllowed)
    if (file.starts_with(rule.first + "/") && (!best || rule.first.size() > best->first.size()))
      best = &rule;
  return best;
}

TEST(IncludeRules, FoldersIncludeOnlyWhatTheDesignAllows) {
  const fs::path root = SHADOWBENCH_SOURCE_DIR;
  const std::regex include("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
  int files = 0, checked = 0;
  for (const char* top : {"base", "backends", "techniques", "shaders", "suites", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), root);
      const auto* rule = ruleOf(file);
      ASSERT_NE(rule, nullptr) << file << " lies in a folder without a rule";
      ++files;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        const std::string target = match[2];
        const bool isBackend = file.starts_with("backends/vulkan/") || file.starts_with("backends/opengl/");
        if (match[1] == "<") {
          EXPECT_TRUE(isBackend || !std::regex_search(target, kApiHeader))
              << file << " includes <" << target << ">";
          continue;
        }
        ++checked;
        // Text and numbers know nothing of what they are of; backends do without them.
        bool allowed = target.starts_with(rule->first + "/") ||
                       (target.starts_with("base/") && !file.starts_with("backends/"));
        for (const std::string& prefix : rule->second) allowed |= target.starts_with(prefix);
        EXPECT_TRUE(allowed) << file << " may not include \"" << target << "\"";
      }
    }
  EXPECT_GT(files, 100);
  EXPECT_GT(checked, 300);
}

}  // namespace
