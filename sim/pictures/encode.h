#pragma once

#include <filesystem>
#include <string>

#include "hw/base/error.h"
#include "sim/pictures/raster.h"

namespace csgsim::pictures {

/// No picture's format has the ending of a name.
class FormatError : public InputError {
 public:
  using InputError::InputError;
};

enum class Samples { bytes, floats };

/// Throws FormatError unless the path's extension names a format for pictures that can be written here. Where that
/// takes the module of formats, it is opened from now on, beside what the caller does next.
void check_format(const std::filesystem::path& path, Samples samples);

/// The bytes of a picture's file, in the format that the path's extension names: PNG of bytes by libpng, all else by
/// the module of formats. The same picture has the same bytes, whenever it is written. Throws InputError.
std::string encode(const std::filesystem::path& path, const Raster& raster);

}  // namespace csgsim::pictures
