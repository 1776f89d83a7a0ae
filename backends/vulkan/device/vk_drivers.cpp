#include "backends/vulkan/device/vk_drivers.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace vulkan {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMostBytes = 1 << 20;

std::vector<std::string> paths(const char* variable) {
  const char* text = std::getenv(variable);
  std::vector<std::string> out;
  if (!text) return out;
  const std::string list = text;
  for (size_t start = 0; start <= list.size();) {
    const size_t end = std::min(list.find(':', start), list.size());
    if (end > start) out.push_back(list.substr(start, end - start));
    start = end + 1;
  }
  return out;
}

void addFolder(const fs::path& folder, std::vector<std::string>& manifests) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") manifests.push_back(entry.path().string());
}

/// Those of the variable that replaces all folders, if it is set, else of the loader's folders.
std::vector<std::string> manifests(std::string& variable) {
  for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
    if (std::getenv(name)) {
      variable = name;
      return paths(name);
    }
  std::vector<std::string> found = paths("VK_ADD_DRIVER_FILES");
  std::vector<std::string> folders = {"/etc/xdg", "/etc", "/usr/local/share", "/usr/share"};
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_DIRS"})
    for (const std::string& folder : paths(name)) folders.push_back(folder);
  if (const char* home = std::getenv("HOME"))
    for (const char* folder : {"/.config", "/.local/share"})
      folders.push_back(std::string(home) + folder);
  std::ranges::sort(folders);
  folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
  for (const std::string& folder : folders) addFolder(folder + "/vulkan/icd.d", found);
  return found;
}

std::string libraryOf(const std::string& manifest, std::string& why) {
  std::error_code error;
  const uintmax_t size = fs::file_size(manifest, error);
  if (error || size > kMostBytes) {
    why = error ? error.message() : "it is too large";
    return "";
  }
  std::ifstream in(manifest);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  const auto icd = json.is_object() ? json.find("ICD") : json.end();
  if (!json.is_object() || icd == json.end() || !icd->is_object() ||
      !icd->contains("library_path") || !(*icd)["library_path"].is_string()) {
    why = "it names no ICD.library_path";
    return "";
  }
  const std::string library = (*icd)["library_path"];
  // A path counts from the manifest, a name is looked up.
  if (library.find('/') == library.npos || library.starts_with('/')) return library;
  return (fs::path(manifest).parent_path() / library).string();
}

/// "" when the driver loads.
std::string troubleOf(const std::string& manifest) {
  std::string why;
  const std::string library = libraryOf(manifest, why);
  if (library.empty()) return "the driver manifest " + manifest + " cannot be used: " + why;
  void* handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (handle) {
    dlclose(handle);
    return "";
  }
  const char* text = dlerror();
  return "a driver is installed, but its library " + library + " does not load (" + manifest +
         "): " + (text ? text : "unknown reason");
}

}  // namespace

std::vector<std::string> brokenDrivers() {
  std::string variable;
  std::vector<std::string> out;
  for (const std::string& manifest : manifests(variable))
    if (const std::string trouble = troubleOf(manifest); !trouble.empty()) out.push_back(trouble);
  return out;
}

std::string whyNoDriver() {
  std::string variable, out;
  for (const std::string& manifest : manifests(variable)) {
    std::error_code error;
    const std::string trouble =
        fs::exists(manifest, error) ? troubleOf(manifest)
                                    : variable + " names " + manifest + ", which is not there";
    if (!trouble.empty()) out += (out.empty() ? "" : "; ") + trouble;
  }
  return out.empty() ? "no Vulkan driver is installed" : out;
}

}  // namespace vulkan
