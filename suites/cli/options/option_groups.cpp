#include "suites/cli/options/option_groups.h"

#include "base/number.h"
#include "base/percent.h"
#include "suites/cli/output_files.h"
#include "suites/harness/suite/suite.h"
#include "suites/scenes/edit/scene_edit.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

constexpr base::NumberRule kSeed{.low = 0, .high = UINT32_MAX, .whole = true};
constexpr base::NumberRule kExposure{.low = 1e-30, .high = 1e9};

void addSize(CLI::App& app, Options& o) {
  app.add_option_function<std::string>(
         "--size",
         [&o](const std::string& text) {
           o.selection.size = base::readSize(text);
           if (!o.selection.size)
             throw InputError("--size",
                              "found '" + text + "', expected " + std::string(base::kSizeForm));
         },
         "of the picture [512x512]")
      ->type_name("WxH");
}

/// Options that choose what of a scene's file is read and shown.
void addFileOptions(CLI::App& app, Options& o) {
  const auto edit = [&o](std::string text) { o.selection.edits.push_back(std::move(text)); };
  app.add_option_function<std::string>(
         "--camera",
         [edit](const std::string& text) {
           const bool place = text.starts_with("eye=") || text.starts_with("at=") ||
                              text.starts_with("fov=");
           edit("camera:" + (place ? text : "show=" + base::percentEncoded(text)));
         },
         "one of the scene's cameras, or look from one world point at another")
      ->type_name("NAME|INDEX|eye=X,Y,Z,at=X,Y,Z[,fov=DEG]");
  app.add_option_function<std::string>(
         "--gltf-scene",
         [edit](const std::string& text) { edit("file:scene=" + base::percentEncoded(text)); },
         "which scene of a glTF file [the one that it names]")
      ->type_name("NAME|INDEX");
  app.add_flag_function(
      "--ground", [edit](int64_t) { edit("ground:size=4"); },
      "a plane below the scene that receives its shadow");
  app.add_flag_function(
      "--allow-outside", [edit](int64_t) { edit("file:outside=1"); },
      "let a glTF file name files outside its own folder");
}

}  // namespace

CLI::Option* addNumber(CLI::App& app, const std::string& name, const base::NumberRule& rule,
                       const std::function<void(double)>& set, const std::string& help,
                       const std::string& type) {
  const std::string shown = name.substr(0, name.find(','));
  return app
      .add_option_function<std::string>(
          name,
          [rule, set, shown](const std::string& text) {
            const auto value = base::readNumber(text, rule);
            if (!value)
              throw InputError(shown,
                               "found '" + text + "', expected " + base::describe(rule));
            set(*value);
          },
          help)
      ->type_name(type);
}

void addExposure(CLI::App& app, Options& o) {
  addNumber(
      app, "--exposure", kExposure, [&o](double v) { o.exposure = float(v); },
      "factor on linear values before they are shown, and compared as shown [1; scenes that are not "
      "lit for display: by the picture's log average, in whole stops]",
      "FACTOR");
}

void addMaxMemory(CLI::App& app, Options& o) {
  addNumber(
      app, "--max-memory", {.low = 0, .high = 1e9, .above = true},
      [&o](double mib) { o.device.maxMemory = uint64_t(mib * (1 << 20)); },
      "what scenes, pictures, truths and software devices may take [half of the machine's]", "MIB");
}

void refuseStray(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : app.get_options())
      if (option->count() > 0)
        throw InputError(option->get_name(), "found it before '" + command->get_name() +
                                                 "', expected the options of a command behind it");
}

void addScene(CLI::App& app, Options& o) {
  app.add_option("--scene", o.selection.scenes, "NAME[:param=value,...] or FILE.gltf or FILE.glb")
      ->type_name("SCENE");
  addSize(app, o);
  app.add_option("--set-material", o.selection.edits,
                 "other optics for materials by glob, in all scenes: 'fabric*:alpha=0.5,t=0.9,0.3,"
                 "0.3'")
      ->type_name("GLOB:alpha=A[,t=R,G,B]");
  addFileOptions(app, o);
  app.add_option_function<std::string>(
         "--sun", [&o](const std::string& text) { o.selection.edits.push_back("sun:" + text); },
         "one directional light instead of the scene's")
      ->type_name("direction=X,Y,Z[,lux=E]");
  app.add_option_function<std::string>(
         "--motion",
         [&o](const std::string& text) { o.selection.edits.push_back("motion:" + text); },
         "the camera arrives at its place from so far away in N frames [8], again and again; what "
         "moves in the scene, or an animation of a file, goes its way in as many; light frusta are "
         "refitted and orders sorted within each frame")
      ->type_name("[move=X,Y,Z][,turn=DEG][,animation=NAME|INDEX][,steps=N]");
}

void addSelection(CLI::App& app, Options& o) {
  addScene(app, o);
  app.add_option("--technique", o.selection.techniques,
                 "TECHNIQUE[+TRANSPARENCY][@LIGHTS]; repeat or separate by commas")
      ->delimiter(',')
      ->type_name("NAME");
  app.add_option("--backend", o.selection.backends, "vulkan, opengl (EGL) or opengl-osmesa")
      ->delimiter(',')
      ->type_name("NAME");
  app.add_option("--set", o.selection.sets, "knob=value; several values make a sweep")
      ->type_name("KNOB=V1[,V2...]");
  addNumber(
      app, "--seed", kSeed, [&o](double v) { o.selection.seed = uint32_t(v); },
      "of random numbers [0]", "N");
}

void addCommon(CLI::App& app, Options& o) {
  app.add_option("--gl", o.device.gl, "how OpenGL is reached when no backend is named [egl]")
      ->check(CLI::IsMember({"egl", "osmesa"}))
      ->type_name("egl|osmesa");
  app.add_option("--device", o.device.selector, "number or part of the name, see `bench doctor`")
      ->type_name("N|NAME");
  app.add_option("--shaders", o.device.shaderFolder,
                 "compile the shaders of a folder instead of the built-in")
      ->type_name("DIR");
  app.add_flag("--validate", o.device.validate,
               "switch on the drivers' validation and our own (slower; results are marked)");
  app.add_flag("--quiet", o.quiet, "no progress line");
  addMaxMemory(app, o);
}

CLI::App* addReport(CLI::App& app, Options& o) {
  CLI::App* report =
      app.add_subcommand("report", "write the HTML page of results (no device needed)");
  report->add_option("results", o.report.results, "what --json wrote")
      ->required()
      ->type_name("FILE.json");
  report->add_option("--output,-o", o.files.html, "the page [FILE.html]")->type_name("FILE");
  report->add_option("--pictures", o.report.pictures, "folder of the pictures [FILE.pictures]")
      ->type_name("DIR");
  return report;
}

}  // namespace sb
