// Groups of options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "base/number.h"
#include "suites/cli/options/options.h"

namespace sb {

/// Calls `set` with an option's number. CLI11's own conversions wrap, and take "nan".
CLI::Option* addNumber(CLI::App& app, const std::string& name, const base::NumberRule& rule,
                       const std::function<void(double)>& set, const std::string& help,
                       const std::string& type);
void addExposure(CLI::App& app, Options& o);
void addMaxMemory(CLI::App& app, Options& o);
/// Throws InputError for options before a command's name: they are the measuring ones, and with a
/// command they would be lost.
void refuseStray(const CLI::App& app);
/// Options that choose a scene, its changes and its size.
void addScene(CLI::App& app, Options& o);
/// Options that choose cells: the same for measuring and for `render`.
void addSelection(CLI::App& app, Options& o);
/// Options of every command that opens a device.
void addCommon(CLI::App& app, Options& o);
/// The command `report`.
CLI::App* addReport(CLI::App& app, Options& o);

}  // namespace sb
