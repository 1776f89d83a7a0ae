#include "reports/exr.h"

#include <tinyexr.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"

namespace report {
namespace {

struct Channel {
  std::string name;
  const ExrLayer* layer = nullptr;
  size_t component = 0;
};

/// In the order of a file: by name.
std::vector<Channel> channelsOf(std::span<const ExrLayer> layers) {
  std::vector<Channel> channels;
  for (const ExrLayer& layer : layers)
    for (size_t c = 0; c < 4; ++c)
      channels.push_back({(layer.name.empty() ? "" : layer.name + ".") + "RGBA"[c], &layer, c});
  std::ranges::sort(channels, {}, &Channel::name);
  return channels;
}

/// One component of a picture, row 0 at the top.
std::vector<float> plane(const Channel& channel, uint32_t width, uint32_t height) {
  std::vector<float> out;
  out.reserve(size_t(width) * height);
  for (uint32_t y = height; y-- > 0;)
    for (uint32_t x = 0; x < width; ++x)
      out.push_back(channel.layer->rgba[4 * (size_t(y) * width + x) + channel.component]);
  return out;
}

/// Rows are compressed 16 together, or one by one where that would be more than an int counts.
int compressionFor(const std::filesystem::path& path, size_t bytesOfRow) {
  if (bytesOfRow > INT_MAX)
    throw std::runtime_error("cannot write " + path.string() + ": a row of " + std::to_string(bytesOfRow) +
                             " bytes is too long for OpenEXR");
  return bytesOfRow * 16 > INT_MAX ? TINYEXR_COMPRESSIONTYPE_ZIPS : TINYEXR_COMPRESSIONTYPE_ZIP;
}

}  // namespace

void writeExr(const std::filesystem::path& path, uint32_t width, uint32_t height,
              std::span<const ExrLayer> layers) {
  const std::vector<Channel> channels = channelsOf(layers);
  std::vector<std::vector<float>> planes;
  std::vector<unsigned char*> images;
  std::vector<EXRChannelInfo> infos(channels.size());
  std::vector<int> types(channels.size(), TINYEXR_PIXELTYPE_FLOAT);
  for (size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].name.size() >= sizeof infos[c].name)
      throw std::runtime_error("cannot write " + path.string() + ": a channel's name is too long");
    channels[c].name.copy(infos[c].name, sizeof infos[c].name - 1);
    planes.push_back(plane(channels[c], width, height));
    images.push_back(reinterpret_cast<unsigned char*>(planes.back().data()));
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = int(channels.size());
  header.channels = infos.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = compressionFor(path, size_t(width) * channels.size() * sizeof(float));
  header.long_name =
      std::ranges::any_of(channels, [](const Channel& c) { return c.name.size() > 31; });
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = header.num_channels;
  image.images = images.data();
  image.width = int(width);
  image.height = int(height);
  unsigned char* bytes = nullptr;
  const char* error = nullptr;
  const size_t size = SaveEXRImageToMemory(&image, &header, &bytes, &error);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owned(bytes, &std::free);
  if (size == 0) {
    const std::string why = error ? error : "unknown reason";
    if (error) FreeEXRErrorMessage(error);
    throw std::runtime_error("cannot write " + path.string() + ": " + why);
  }
  base::writeAtomically(path, {reinterpret_cast<const char*>(bytes), size});
}

}  // namespace report
