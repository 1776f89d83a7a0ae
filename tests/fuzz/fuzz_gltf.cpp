// fuzz_gltf [--seconds N] [--inputs N] [--seed S] [--corpus DIR] [--keep DIR] [--write-corpus DIR]
// Loads changed files until the time or the number is spent, or a signal asks for what was done so
// far; ends with 1 on the first ten faults,
// on a crash, on an input that takes longer than ten seconds, and when memory passes 3 GiB. What
// fell over lies in the --keep folder [fuzz-faults].
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "tests/fuzz/mutate.h"
#include "tests/fuzz/oracle.h"
#include "tests/scenes/gltf_packed.h"
#include "tests/scenes/png_bytes.h"

namespace {

namespace fs = std::filesystem;
using sb::fuzz::Outcome;

char inputPath[512], crashPath[512];  // for the signal handler, which may not allocate

void onSignal(int number) {
  rename(inputPath, crashPath);
  const char text[] = "\nfuzz_gltf: crashed, hung or ran out of memory on the input kept as ";
  (void)!write(2, text, sizeof text - 1);
  (void)!write(2, crashPath, std::strlen(crashPath));
  (void)!write(2, "\n", 1);
  _exit(number == SIGALRM ? 3 : 4);
}

volatile sig_atomic_t stopped = 0;

void onStop(int) { stopped = 1; }

struct Settings {
  double seconds = 0;
  uint64_t inputs = 0, seed = 1;
  fs::path corpus, keep = "fuzz-faults", writeCorpus;
};

std::vector<std::pair<std::string, std::string>> builtFiles() {
  using namespace sb::test;
  nlohmann::json textured = triangleFile();
  textured["images"][0]["uri"] = "data:image/png;base64," + base64(pngBytes(3, 2));
  textured["textures"] = nlohmann::json::parse(R"([{"source": 0, "sampler": 0}])");
  textured["samplers"] = nlohmann::json::parse(R"([{"wrapS": 33071, "magFilter": 9728}])");
  textured["materials"] = nlohmann::json::parse(R"([{
    "alphaMode": "MASK",
    "pbrMetallicRoughness": {"baseColorTexture": {
      "index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}},
    "normalTexture": {"index": 0, "scale": 0.5},
    "extensions": {
      "KHR_materials_transmission": {"transmissionFactor": 0.5},
      "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 2}}}])");
  textured["meshes"][0]["primitives"][0]["material"] = 0;
  textured["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      addFloats(textured, {0, 0, 1, 0, 0, 1}, 2);
  textured["nodes"][0]["scale"] = {-1, 2, 3};
  nlohmann::json sparse = triangleFile();
  sparse["accessors"][0]["sparse"] = nlohmann::json::parse(R"({
    "count": 1,
    "indices": {"bufferView": 0, "componentType": 5125, "byteOffset": 16},
    "values": {"bufferView": 0, "byteOffset": 12}})");
  nlohmann::json smoke = triangleFile();
  smoke["nodes"][0]["extras"]["shadowbench"]["medium"] = {{"extinction", {1, 1, 1}}};
  smoke["scenes"][0]["extras"]["shadowbench"] = {{"ambient", {0, 0, 0}}, {"sky", {0, 0, 1}}};
  nlohmann::json lamps = camerasAndLightsFile();
  nlohmann::json& lights = lamps["extensions"]["KHR_lights_punctual"]["lights"];
  lights[0]["extras"]["shadowbench"] = {{"radius", 0.1}};
  lights[1]["extras"]["shadowbench"] = {{"shape", "ellipsoid"}, {"half_axes", {1, 2, 3}}};
  lights[2]["extras"]["shadowbench"] = {{"shape", "rectangle"}, {"half_axes", {1, 2}}};
  return {{"triangle", triangleFile().dump()},
          {"lamps", lamps.dump()},
          {"skin", skinnedFile().dump()},
          {"morph", morphedFile().dump()},
          {"animation", animatedFile().dump()},
          {"instances", instancedFile().dump()},
          {"lights", camerasAndLightsFile().dump()},
          {"meshopt", meshoptFile().dump()},
          {"draco", dracoFile().dump()},
          {"webp", webpFile().dump()},
          {"textured", textured.dump()},
          {"binary", sb::fuzz::asGlb(textured.dump())},
          {"sparse", sparse.dump()},
          {"smoke", smoke.dump()}};
}

void writeFile(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::vector<std::string> readCorpus(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.file_size() < 65536) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> files;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return files;
}

void guard() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM})
    signal(number, onSignal);
  for (const int number : {SIGINT, SIGTERM}) signal(number, onStop);
#if !defined(__SANITIZE_ADDRESS__)
  const rlimit limit{size_t(3) << 30, size_t(3) << 30};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

int run(const Settings& settings) {
  const std::vector<std::string> corpus = readCorpus(settings.corpus);
  if (corpus.empty()) return std::fprintf(stderr, "fuzz_gltf: no corpus\n"), 2;
  const fs::path folder =
      fs::temp_directory_path() / ("shadowbench-fuzz-" + std::to_string(getpid()));
  fs::create_directories(folder);
  fs::create_directories(settings.keep);
  std::snprintf(inputPath, sizeof inputPath, "%s", (folder / "in.gltf").c_str());
  guard();
  sb::fuzz::Random random(settings.seed);
  std::map<std::string, uint64_t> faults;
  uint64_t inputs = 0, loaded = 0, refused = 0;
  double slowest = 0;
  const auto start = std::chrono::steady_clock::now();
  const auto since = [](auto from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  };
  while (!stopped && (settings.inputs == 0 || inputs < settings.inputs) &&
         (settings.seconds == 0 || since(start) < settings.seconds) && faults.size() < 10) {
    const std::string input = sb::fuzz::mutated(corpus[random() % corpus.size()],
                                                corpus[random() % corpus.size()], random);
    writeFile(inputPath, input);
    std::snprintf(crashPath, sizeof crashPath, "%s/crash-%llu-%llu.gltf", settings.keep.c_str(),
                  static_cast<unsigned long long>(settings.seed),
                  static_cast<unsigned long long>(inputs));
    const itimerval timer{{0, 0}, {10, 0}};
    setitimer(ITIMER_REAL, &timer, nullptr);
    const auto before = std::chrono::steady_clock::now();
    const auto verdict =
        sb::fuzz::judge(inputPath, inputs % 8 == 0 ? folder / "out.glb" : fs::path());
    const double taken = since(before);
    if (taken > slowest) {
      slowest = taken;
      writeFile(settings.keep / "slowest.gltf", input);
    }
    ++inputs;
    loaded += verdict.outcome == Outcome::Loaded;
    refused += verdict.outcome == Outcome::Refused;
    if (verdict.outcome == Outcome::Fault && faults[verdict.why.substr(0, 60)]++ == 0) {
      const fs::path kept = settings.keep / ("fault-" + std::to_string(settings.seed) + "-" +
                                             std::to_string(inputs) + ".gltf");
      writeFile(kept, input);
      std::fprintf(stderr, "fuzz_gltf: %s (%s)\n", verdict.why.c_str(), kept.c_str());
    }
  }
  const itimerval off{};
  setitimer(ITIMER_REAL, &off, nullptr);
  fs::remove_all(folder);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf(
      "%llu inputs (%llu loaded, %llu refused) in %.0f s, seed %llu; slowest %.2f s; "
      "%ld MiB at most; %zu kinds of faults\n",
      static_cast<unsigned long long>(inputs), static_cast<unsigned long long>(loaded),
      static_cast<unsigned long long>(refused), since(start),
      static_cast<unsigned long long>(settings.seed), slowest, usage.ru_maxrss >> 10,
      faults.size());
  return faults.empty() && loaded > 0 && refused > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--seconds")
      settings.seconds = std::stod(value);
    else if (name == "--inputs")
      settings.inputs = std::stoull(value);
    else if (name == "--seed")
      settings.seed = std::stoull(value);
    else if (name == "--corpus")
      settings.corpus = value;
    else if (name == "--keep")
      settings.keep = value;
    else if (name == "--write-corpus")
      settings.writeCorpus = value;
    else
      return std::fprintf(stderr, "fuzz_gltf: unknown option %s\n", argv[i]), 2;
  }
  if (!settings.writeCorpus.empty()) {
    for (const auto& [name, text] : builtFiles())
      writeFile(settings.writeCorpus / (name + ".gltf"), text);
    return 0;
  }
  if (settings.seconds == 0 && settings.inputs == 0) settings.seconds = 60;
  return run(settings);
}
