// Encodes pictures in common file formats.
// Used by sim/observe, sim/python, sim/report, sim/session, sim/viewer and sim/web.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "hw/base/error.h"
#include "sim/pictures/module.h"
#include "sim/pictures/raster.h"

namespace csgsim::pictures {

/// Thrown for a file name whose extension belongs to no picture format.
class FormatError : public InputError {
 public:
  using InputError::InputError;
};

enum class Samples { bytes, floats };

/// Throws FormatError unless the path's extension names a supported picture format. If the format needs the module,
/// opening it starts now, in parallel with the caller.
void check_format(const std::filesystem::path& path, Samples samples);

/// The bytes of a picture file in the format of the path's extension: PNG of bytes by libpng, all others by the module
/// of formats. Equal pictures always give equal bytes. Throws InputError.
std::string encode(const std::filesystem::path& path, const Raster& raster);

/// Whether several pictures can be written into one file of that name: an animated GIF.
bool is_animated(const std::filesystem::path& path);

/// Encodes one picture after another into one file, without keeping them. Each function returns the bytes that follow
/// those of the calls before. They throw InputError.
class Animation {
 public:
  Animation(std::filesystem::path path, unsigned pictures_per_second);
  std::string add(const Raster& raster);
  std::string finish();

 private:
  std::filesystem::path path_;
  std::unique_ptr<AnimationWriter> writer_;
};

}  // namespace csgsim::pictures
