#include "sim/pictures/encode.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "sim/pictures/module_loader.h"
#include "sim/pictures/png.h"
#include "sim/system/memory_file.h"

namespace csgsim::pictures {

namespace {

constexpr std::string_view png_extension = ".png";
constexpr std::string_view gif_extension = ".gif";

/// Extensions that the module is known to support; no need to wait for it.
constexpr auto known_extensions = std::to_array<std::string_view>({".exr", ".jpg", ".ppm", ".tif"});

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().native();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

[[noreturn]] void throw_no_format(const std::filesystem::path& path) {
  throw FormatError(
      path.native() +
      ": unknown picture format; end the name in .png, .tif, .ppm, .exr or another extension of pictures");
}

[[noreturn]] void throw_unwritten(const std::filesystem::path& path, const std::string& why) {
  throw InputError(path.native() + ": cannot be written: " + why);
}

std::string bytes_of(const std::filesystem::path& path, Encoded&& encoded) {
  if (!encoded.error.empty()) throw_unwritten(path, encoded.error);
  return std::move(encoded.bytes);
}

std::string encode_by_module(const std::filesystem::path& path, const Raster& raster) {
  const Module& module = wait_for_module(path);
  const Target target = module.target_for(path.c_str());
  if (target == Target::none) throw_no_format(path);
  Encoded encoded;
  if (target == Target::memory) {
    encoded = module.encode(path.c_str(), nullptr, raster);
  } else {
    const system::MemoryFile file(path);
    encoded = module.encode(path.c_str(), file.path().c_str(), raster);
    if (encoded.error.empty()) encoded.bytes = file.content();
  }
  std::string bytes = bytes_of(path, std::move(encoded));
  if (bytes.empty()) throw InputError(path.native() + ": this format creates no file; use .png");
  return bytes;
}

}  // namespace

void check_format(const std::filesystem::path& path, Samples samples) {
  const std::string extension = extension_of(path);
  if (extension == png_extension && samples == Samples::bytes) return;
  start_opening_module(path);
  if (extension == png_extension || std::ranges::find(known_extensions, extension) != known_extensions.end()) return;
  if (wait_for_module(path).target_for(path.c_str()) == Target::none) throw_no_format(path);
}

std::string encode(const std::filesystem::path& path, const Raster& raster) {
  const auto* const bytes = std::get_if<Bytes>(&raster.samples);
  if (bytes == nullptr || extension_of(path) != png_extension) return encode_by_module(path, raster);
  Encoded encoded = encode_png(raster, *bytes);
  return bytes_of(path, std::move(encoded));
}

bool is_animated(const std::filesystem::path& path) { return extension_of(path) == gif_extension; }

Animation::Animation(std::filesystem::path path, unsigned pictures_per_second)
    : path_(std::move(path)), writer_(wait_for_module(path_).animate(pictures_per_second)) {
  if (!writer_) throw_unwritten(path_, "this OpenImageIO writes no animated GIF; use numbered .png files");
}

std::string Animation::add(const Raster& raster) { return bytes_of(path_, writer_->add(raster)); }

std::string Animation::finish() { return bytes_of(path_, writer_->finish()); }

}  // namespace csgsim::pictures
