#include "backends/shader/collect.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "backends/rhi/error.h"

namespace shader {
namespace fs = std::filesystem;
namespace {

std::optional<rhi::ShaderStage> stageOf(const fs::path& file) {
  const std::string stage = file.stem().extension().string();  // "x.frag.glsl" -> ".frag"
  if (file.extension() != ".glsl") return {};
  if (stage == ".vert") return rhi::ShaderStage::Vertex;
  if (stage == ".geom") return rhi::ShaderStage::Geometry;
  if (stage == ".frag") return rhi::ShaderStage::Fragment;
  if (stage == ".comp") return rhi::ShaderStage::Compute;
  return {};
}

bool mentions(const fs::path& file, std::string_view text) {
  std::ifstream in(file);
  const std::string content(std::istreambuf_iterator<char>(in), {});
  return content.find(text) != std::string::npos;
}

}  // namespace

std::vector<CompileJob> collect(const fs::path& root) {
  if (!fs::is_directory(root))
    throw rhi::Error("shader compilation", "", root.string() + " is not a folder");
  std::set<std::string> techniques, transparencies;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    std::error_code broken;  // a link that leads nowhere, or in circles
    if (!entry.is_regular_file(broken)) continue;
    const fs::path file = fs::relative(entry.path(), root);
    files.push_back(file);
    if (file.filename() == "visibility.glsl") techniques.insert(file.parent_path().string());
    if (file.filename() == "emit.glsl") transparencies.insert(file.parent_path().string());
  }
  std::vector<CompileJob> jobs;
  for (const fs::path& file : files) {
    const auto stage = stageOf(file);
    if (!stage) continue;
    const std::string pass = file.stem().string();
    const bool isTemplate = file.parent_path() == "templates";
    const bool perTechnique = isTemplate && mentions(root / file, "#include <technique/");
    const bool perPair = isTemplate && mentions(root / file, "#include <transparency/");
    if (!perTechnique && !perPair) {
      jobs.push_back({.name = (file.parent_path() / pass).string(),
                      .root = root,
                      .file = file,
                      .stage = *stage,
                      .aliases = {}});
      continue;
    }
    for (const std::string& t : techniques) {
      if (!perPair) {
        jobs.push_back({.name = t + "/" + pass,
                        .root = root,
                        .file = file,
                        .stage = *stage,
                        .aliases = {{"technique", t}}});
        continue;
      }
      for (const std::string& x : transparencies)
        jobs.push_back({.name = t + "+" + x + "/" + pass,
                        .root = root,
                        .file = file,
                        .stage = *stage,
                        .aliases = {{"technique", t}, {"transparency", x}}});
    }
  }
  std::ranges::sort(jobs, {}, &CompileJob::name);
  return jobs;
}

rhi::ShaderLibrary compileFolder(const fs::path& root, const fs::path& include) {
  rhi::ShaderLibrary library;
  for (CompileJob& job : collect(root)) {
    job.include = include;
    library.add(compile(job));
  }
  return library;
}

}  // namespace shader
