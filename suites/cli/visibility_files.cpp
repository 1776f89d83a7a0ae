#include "suites/cli/visibility_files.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "reports/contact_sheet.h"
#include "reports/exr.h"
#include "suites/cli/say.h"

namespace sb {
namespace {

/// More would be a few pixels each.
constexpr size_t kMostStrips = 1000;

bool holdsNothing(const std::vector<float>& rgba) {
  for (size_t p = 3; p < rgba.size(); p += 4)
    if (rgba[p] != 0) return false;
  return true;
}

std::string layerName(uint32_t layer) {
  if (layer == kWithinMedia) return "media";
  return layer == 0 ? "opaque" : "layer" + std::to_string(layer);
}

/// "0, 2 to 4": the first `count`.
std::string listed(const std::set<uint32_t>& numbers, size_t count) {
  std::string out;
  auto it = numbers.begin();
  while (count > 0) {
    const uint32_t first = *it;
    uint32_t last = first;
    for (++it, --count; count > 0 && *it == last + 1; ++it, --count) last = *it;
    out += (out.empty() ? "" : ", ") + std::to_string(first) +
           (last > first ? " to " + std::to_string(last) : "");
  }
  return out;
}

struct Sheet {
  std::vector<std::span<const float>> cells;
  uint32_t columns = 0;
  std::string legend;
};

/// Strips, one a light, of one cell a layer; side by side so that the whole is nearly square.
Sheet arrange(const VisibilityLayers& layers, rhi::Extent2D size) {
  std::set<uint32_t> lights, used;
  for (const auto& [key, rgba] : layers) {
    lights.insert(key.first);
    used.insert(key.second);
  }
  const size_t strips = std::min(lights.size(), kMostStrips);
  const double stripWidth = double(used.size()) * size.width;
  const size_t across =
      std::max<size_t>(1, size_t(std::round(std::sqrt(double(strips) * size.height / stripWidth))));
  const size_t down = (strips + across - 1) / across;
  Sheet sheet{.cells = {}, .columns = uint32_t(across * used.size()), .legend = ""};
  sheet.cells.resize(down * sheet.columns);
  size_t strip = 0;
  for (const uint32_t light : lights) {
    if (strip == strips) break;
    size_t cell = strip++ * used.size();
    for (const uint32_t layer : used) {
      if (const auto found = layers.find({light, layer}); found != layers.end())
        sheet.cells[cell] = *found->second;
      ++cell;
    }
  }
  for (const uint32_t layer : used)
    sheet.legend += (sheet.legend.empty() ? "" : ", ") + layerName(layer);
  sheet.legend += "; rows: lights " + listed(lights, strips);
  if (across > 1) sheet.legend += ", " + std::to_string(across) + " in a row";
  if (strips < lights.size())
    sheet.legend += "; " + std::to_string(lights.size() - strips) + " more lights in the EXR alone";
  return sheet;
}

}  // namespace

std::vector<std::string> visibilityFiles(const std::string& prefix) {
  return {prefix + ".visibility.png", prefix + ".visibility.exr"};
}

void writeVisibility(const std::string& prefix, rhi::Extent2D size, VisibilityLayers layers) {
  std::erase_if(layers, [](const auto& entry) { return holdsNothing(*entry.second); });
  if (layers.empty()) {
    say("no light can reach what is seen: there is no visibility to write");
    return;
  }
  std::vector<report::ExrLayer> named;
  for (const auto& [key, rgba] : layers)
    named.push_back({"light" + std::to_string(key.first) + "." + layerName(key.second), *rgba});
  const auto files = visibilityFiles(prefix);
  const Sheet sheet = arrange(layers, size);
  report::writePng(files[0],
                   report::contactSheet(size.width, size.height, sheet.cells, sheet.columns));
  report::writeExr(files[1], size.width, size.height, named);
  print(files[0] + " " + files[1] + " (columns: " + sheet.legend + ")\n");
}

}  // namespace sb
