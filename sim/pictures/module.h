#pragma once

#include <string>

#include "sim/pictures/raster.h"

namespace csgsim::pictures {

/// A picture's file, or why there is none.
struct Encoded {
  std::string bytes;
  std::string error;  ///< empty if all went well
};

/// Where a format can be written to.
enum class Target {
  none,    ///< there is no such format, or it makes no file
  memory,  ///< Encoded::bytes
  file,    ///< a file that is named
};

/// The module of picture formats, whose library takes longer to load than most runs: a shared library that is opened
/// when the first picture asks for it. It is of the same build as what opens it.
struct Module {
  /// For what the path's extension names.
  Target (*target_for)(const char* path);

  /// A picture in the format that the path's extension names. `file` is where it goes if that is its target, else null.
  Encoded (*encode)(const char* path, const char* file, const Raster& raster);
};

inline constexpr const char* module_file = "csgsim_pictures.so";

/// Of the only symbol of the module, a Module. It changes with this file, so that another version's is not taken.
inline constexpr const char* module_symbol = "csgsim_pictures_1";

}  // namespace csgsim::pictures
