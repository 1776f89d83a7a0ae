#include "backends/shader/compile.h"

#include <glslang/Include/ResourceLimits.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <list>
#include <sstream>

#include "backends/rhi/error.h"

namespace shader {
namespace {

std::string readText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw rhi::Error("shader compilation", "", "cannot read " + path.string());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Includes are named from the shader root; the first folder may be an alias.
class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(const CompileJob& job) : m_job(job) {}

  IncludeResult* includeSystem(const char* header, const char*, size_t) override {
    std::string name = header;
    const size_t slash = name.find('/');
    auto alias = m_job.aliases.find(name.substr(0, slash));
    if (alias == m_job.aliases.end()) return nullptr;
    return open(alias->second + name.substr(slash));
  }
  IncludeResult* includeLocal(const char* header, const char*, size_t) override {
    return open(header);
  }
  void releaseInclude(IncludeResult*) override {}  // the lists below own everything

 private:
  IncludeResult* open(const std::string& name) {
    std::filesystem::path file = m_job.root / name;
    if (!std::filesystem::exists(file) && !m_job.include.empty()) file = m_job.include / name;
    if (!std::filesystem::exists(file)) return nullptr;
    m_texts.push_back(readText(file));
    m_results.emplace_back(name, m_texts.back().data(), m_texts.back().size(), nullptr);
    return &m_results.back();
  }
  const CompileJob& m_job;
  std::list<std::string> m_texts;
  std::list<IncludeResult> m_results;
};

EShLanguage language(rhi::ShaderStage stage) {
  switch (stage) {
    case rhi::ShaderStage::Vertex:
      return EShLangVertex;
    case rhi::ShaderStage::Geometry:
      return EShLangGeometry;
    case rhi::ShaderStage::Fragment:
      return EShLangFragment;
    case rhi::ShaderStage::Compute:
      return EShLangCompute;
  }
  return EShLangVertex;
}

struct GlslangProcess {
  GlslangProcess() { glslang::InitializeProcess(); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
};

}  // namespace

rhi::ShaderCode compile(const CompileJob& job) {
  static GlslangProcess process;
  const EShLanguage stage = language(job.stage);
  const std::string source = readText(job.root / job.file);
  const std::string fileName = job.file.string();
  const char* text = source.c_str();
  const int length = int(source.size());
  const char* name = fileName.c_str();

  glslang::TShader shader(stage);
  shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
  shader.setPreamble("#extension GL_GOOGLE_include_directive : require\n");
  shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
  Includer includer(job);
  if (!shader.parse(GetDefaultResources(), 450, false, messages, includer))
    throw rhi::Error("shader compilation", "", job.name + "\n" + shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages))
    throw rhi::Error("shader linking", "", job.name + "\n" + program.getInfoLog());

  rhi::ShaderCode code;
  code.name = job.name;
  code.stage = job.stage;
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  glslang::GlslangToSpv(*program.getIntermediate(stage), code.spirv, &options);
  reflect(code);
  return code;
}

}  // namespace shader
