// Interface of the module of picture formats.
// Used by module_loader.h, png.h and encode.h.
#pragma once

#include <memory>
#include <string>

#include "sim/pictures/raster.h"

namespace csgsim::pictures {

/// A picture's file, or an error.
struct Encoded {
  std::string bytes;
  std::string error;  ///< empty on success
};

/// Kinds of output that the encoder of a format supports.
enum class Target {
  none,    ///< unknown format, or one that creates no file
  memory,  ///< Encoded::bytes
  file,    ///< a named file
};

/// Encodes one picture after another into an animated GIF. Each call returns the bytes that follow those of the calls
/// before.
class AnimationWriter {
 public:
  virtual ~AnimationWriter() = default;
  virtual Encoded add(const Raster& raster) = 0;
  virtual Encoded finish() = 0;
};

/// The module of picture formats: a shared library that is opened on first use, since loading it takes longer than most
/// runs. It comes from the same build as the program that opens it.
struct Module {
  /// Target of the format that the path's extension names.
  Target (*target_for)(const char* path);

  /// Encodes a picture in the format of the path's extension. `file` is the output file if the target is a file, else
  /// null.
  Encoded (*encode)(const char* path, const char* file, const Raster& raster);

  /// Begins an animated GIF that shows that number of pictures per second; null if GIF is not supported.
  std::unique_ptr<AnimationWriter> (*animate)(unsigned pictures_per_second);
};

inline constexpr const char* module_file = "csgsim_pictures.so";

/// Name of the only symbol of the module, a Module. It changes with this file, so that a module of another version is
/// not accepted.
inline constexpr const char* module_symbol = "csgsim_pictures_2";

}  // namespace csgsim::pictures
