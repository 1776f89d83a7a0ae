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

/// Folders of plug-ins, by the file that makes them one.
struct Plugins {
  std::set<std::string> techniques, transparencies, lights;
};
struct Folder {
  std::vector<fs::path> files;  ///< relative
  Plugins plugins;
};

Folder scan(const fs::path& root) {
  Folder folder;
  if (root.empty()) return folder;
  if (!fs::is_directory(root))
    throw rhi::Error("shader compilation", "", root.string() + " is not a folder");
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    std::error_code broken;  // a link that leads nowhere, or in circles
    if (!entry.is_regular_file(broken)) continue;
    const fs::path file = fs::relative(entry.path(), root);
    folder.files.push_back(file);
    const std::string parent = file.parent_path().string();
    if (file.filename() == "visibility.glsl") folder.plugins.techniques.insert(parent);
    if (file.filename() == "emit.glsl") folder.plugins.transparencies.insert(parent);
    if (file.filename() == "lights.glsl") folder.plugins.lights.insert(parent);
  }
  return folder;
}

/// A plug-in that a template takes part with; of a question that it does not ask: none.
struct Part {
  std::string folder;
  bool own = false;  ///< below the root, not the folder that may be included
};

std::vector<Part> partsOf(bool asked, const std::set<std::string>& own,
                          const std::set<std::string>& included) {
  if (!asked) return {{}};
  std::vector<Part> parts;
  for (const std::string& name : own) parts.push_back({name, true});
  for (const std::string& name : included)
    if (!own.contains(name)) parts.push_back({name, false});
  return parts;
}

/// Jobs of one file of `root`. Of a template: with all plug-ins if it is `own`, else with those
/// combinations of which one is.
void addJobs(const fs::path& root, const fs::path& file, bool own, const Plugins& ours,
             const Plugins& others, std::vector<CompileJob>& jobs) {
  const auto stage = stageOf(file);
  if (!stage) return;
  const bool isTemplate = file.parent_path() == "templates";
  const auto asks = [&](const char* plugin) {
    return isTemplate && mentions(root / file, std::string("#include <") + plugin + "/");
  };
  const bool ofTechnique = asks("technique"), ofTransparency = asks("transparency"),
             ofLights = asks("lights");
  const bool isPlain = !ofTechnique && !ofTransparency && !ofLights;
  for (const Part& t : partsOf(ofTechnique, ours.techniques, others.techniques))
    for (const Part& x : partsOf(ofTransparency, ours.transparencies, others.transparencies))
      for (const Part& l : partsOf(ofLights, ours.lights, others.lights)) {
        if (!own && !t.own && !x.own && !l.own) continue;
        std::string folder = isPlain ? file.parent_path().string() : t.folder;
        std::map<std::string, std::string> aliases;
        if (ofTechnique) aliases["technique"] = t.folder;
        if (ofTransparency) folder += "+" + x.folder, aliases["transparency"] = x.folder;
        if (ofLights) aliases["lights"] = l.folder;
        // Names leave out what nearly all have.
        if (ofLights && l.folder != "all_lights") folder += "@" + l.folder;
        jobs.push_back({.name = (fs::path(folder) / file.stem()).string(),
                        .root = root,
                        .file = file,
                        .stage = *stage,
                        .aliases = std::move(aliases)});
      }
}

}  // namespace

std::vector<CompileJob> collect(const fs::path& root, const fs::path& include) {
  const Folder own = scan(root), included = scan(include);
  std::vector<CompileJob> jobs;
  for (const fs::path& file : own.files)
    addJobs(root, file, true, own.plugins, included.plugins, jobs);
  for (const fs::path& file : included.files)
    if (std::ranges::find(own.files, file) == own.files.end())
      addJobs(include, file, false, own.plugins, included.plugins, jobs);
  std::ranges::sort(jobs, {}, &CompileJob::name);
  return jobs;
}

rhi::ShaderLibrary compileFolder(const fs::path& root, const fs::path& include) {
  rhi::ShaderLibrary library;
  for (CompileJob& job : collect(root, include)) {
    job.include = job.root == root ? include : root;
    library.add(compile(job));
  }
  return library;
}

}  // namespace shader
