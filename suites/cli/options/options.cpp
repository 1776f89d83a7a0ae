#include "suites/cli/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "base/number.h"
#include "base/percent.h"
#include "base/text.h"
#include "suites/cli/options/help.h"
#include "suites/cli/options/option_groups.h"
#include "suites/cli/output_files.h"
#include "suites/harness/suite/suite.h"
#include "suites/scenes/edit/scene_edit.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// CLI11's own inverted flags show as `--no-truth{false}` in the help.
void addSwitchOff(CLI::App& app, const char* name, bool& value, const std::string& help) {
  app.add_flag_callback(
      name, [&value] { value = false; }, help);
}

/// A picture's path without its ending: who writes `-o x.png` means x.png, not x.png.png.
std::string picturePrefix(const std::string& path) {
  const std::filesystem::path p(path);
  const bool picture = p.extension() == ".png" || p.extension() == ".exr";
  return picture ? std::filesystem::path(p).replace_extension().string() : path;
}

}  // namespace

std::optional<Options> parseOptions(std::vector<std::string> arguments) {
  Options o;
  o.arguments = arguments;
  o.benchmark = takeBenchmarkFlags(arguments);

  CLI::App app{
      "ShadowBench measures techniques for shadows and transparency: what each costs in time and\n"
      "memory on your scene, your GPU and your API, with the picture verified within the run.\n"
      "Without arguments: the suite `quick` of all techniques on all working backends."};
  app.name("bench");
  app.set_version_flag("--version", versionText());
  app.footer(helpFooter);
  addSelection(app, o);
  addCommon(app, o);
  app.add_option("--filter", o.selection.filter, "only cells whose name matches")
      ->type_name("REGEX");
  addNumber(
      app, "--budget", kBudgetSeconds, [&o](double v) { o.measuring.budgetSeconds = v; },
      "seconds to measure each cell at most [3; of a suite: its own]", "SECONDS");
  addNumber(
      app, "--precision", kPrecisionPercent, [&o](double v) { o.measuring.precisionPercent = v; },
      "stop when the 95 % interval of the median is within so much [5]", "PERCENT");
  app.add_option("--json", o.files.json, "write all results (Google Benchmark's schema)")
      ->type_name("FILE");
  app.add_option("--csv", o.files.csv, "write one row a cell")->type_name("FILE");
  app.add_option("--html", o.files.html, "write a report with pictures, one self-contained file")
      ->type_name("FILE");
  app.add_option("--suite", o.measuring.suite,
                 "measure the cells of a suite: " + joinedNames(builtinSuites()) +
                     ", or a file; stability: with --scene, the generic properties of that scene")
      ->type_name("NAME|FILE.toml");
  addNumber(
      app, "--seeds", kSeedCount, [&o](double v) { o.measuring.seeds = uint32_t(v); },
      "seeds that noise and bias of stochastic techniques are taken over [64; of a suite: its own]",
      "N");
  addExposure(app, o);
  app.add_option_function<std::string>(
         "--resume",
         [&o](const std::string& file) {
           o.resume.wanted = true;
           o.resume.file = file == "beside --json" ? "" : file;
         },
         "go on with a run that ended early: its journal, or its results; without a file the "
         "journal beside --json. Alone, it takes the arguments of that run")
      ->expected(0, 1)
      ->default_str("beside --json")
      ->type_name("[FILE]");
  app.add_flag("--allow-skips", o.measuring.allowSkips,
               "exit with 0 although cells were skipped for want of memory");
  addSwitchOff(app, "--no-truth", o.measuring.truth, "no errors: nothing is ray-traced");
  addSwitchOff(app, "--no-cache", o.cache.used, "trace truths anew, and keep none");
  app.add_flag("--list", o.list, "print the names of the cells and stop");

  CLI::App* render = app.add_subcommand("render", "write the picture of one cell as PNG and EXR");
  addSelection(*render, o);
  addCommon(*render, o);
  render
      ->add_option("--output,-o", o.picture.prefix,
                   "path; .png or .exr at its end does not count [render]")
      ->type_name("PREFIX");
  render->add_flag(
      "--visibility", o.picture.visibility,
      "also PREFIX.visibility.exr, what arrives of each light on the first opaque surface and on "
      "four layers (lightN.opaque, lightN.layerM), and PREFIX.visibility.png, all of them to look at");
  addExposure(*render, o);

  CLI::App* scene = app.add_subcommand("scene", "say what is in a scene and what it calls for");
  scene->add_option("scene", o.scene.name, "NAME[:param=value,...] or FILE.gltf or FILE.glb")
      ->required()
      ->type_name("SCENE");
  addFileOptions(*scene, o);
  scene->add_flag("--json", o.scene.json, "as JSON");
  scene->add_option("--export", o.scene.exportFile, "write the scene as a .glb file")
      ->type_name("FILE");

  CLI::App* truth =
      app.add_subcommand("truth", "write the ray-traced truth of a scene: its picture and "
                                    "its edges, and the visibility of all lights in one EXR");
  addScene(*truth, o);
  addMaxMemory(*truth, o);
  truth
      ->add_option("--output,-o", o.picture.prefix,
                   "path; .png or .exr at its end does not count [truth]")
      ->type_name("PREFIX");
  addExposure(*truth, o);
  addSwitchOff(*truth, "--no-cache", o.cache.used, "trace anew, and keep nothing");
  truth->add_flag("--quiet", o.quiet, "no progress line");
  CLI::App* cache = app.add_subcommand("cache", "say how many truths and unfinished runs are kept on disk, and where");
  cache->add_flag(
      "--clear", o.cache.clear,
      "remove them: the truths, and journals of runs that ended early (not those beside a "
      "--json file, nor of runs under way)");

  CLI::App* doctor =
      app.add_subcommand("doctor", "list devices, drivers, features and timer facts");
  addCommon(*doctor, o);
  CLI::App* report = addReport(app, o);
  app.require_subcommand(0, 1);

  // CLI11 would take the next argument for the value.
  for (const std::string& a : arguments)
    if (a.starts_with("--") && a.find('=') + 1 == a.size())
      throw InputError(a.substr(0, a.size() - 1), "found an empty text");
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes a vector back to front
  try {
    app.parse(arguments);
  } catch (const CLI::Success& e) {
    app.exit(e);
    return {};
  } catch (const CLI::ExtrasError&) {
    std::string extras;
    for (const std::string& word : app.remaining(true)) extras += " " + base::shellWord(word);
    throw InputError("", "not expected:" + extras + " (see bench --help)");
  } catch (const CLI::ParseError& e) {
    throw InputError("", std::string(e.what()) + " (see bench --help)");
  }
  refuseStray(app);
  if (render->parsed()) o.command = Command::Render;
  if (scene->parsed()) o.command = Command::Scene;
  if (doctor->parsed()) o.command = Command::Doctor;
  if (cache->parsed()) o.command = Command::Cache;
  if (truth->parsed()) {
    o.command = Command::Truth;
    if (truth->count("--output") == 0) o.picture.prefix = "truth";
  }
  o.picture.prefix = picturePrefix(o.picture.prefix);
  if (report->parsed()) o.command = Command::Report;
  if (o.command != Command::Measure && !o.benchmark.arguments.empty())
    throw InputError(o.benchmark.arguments.front(),
                     "found it beside a command; it is of measuring");
  if (!o.benchmark.filter.empty()) {
    if (!o.selection.filter.empty())
      throw InputError("--filter", "found it beside --benchmark_filter, expected one of the two");
    o.selection.filter = o.benchmark.filter;
    o.selection.filterExcludes = o.benchmark.filterExcludes;
  }
  o.list |= o.benchmark.list;
  requireSaneFiles(app, o);
  return o;
}

}  // namespace sb
