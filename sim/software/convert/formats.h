#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/software/convert/surface.h"

namespace csgsim::software::convert {

/// How a file is written.
struct Writing {
  bool is_text = false;  ///< if the format has a binary form too
};

/// A row of the table of formats that hold a surface; each has a file of its own.
struct Format {
  std::string_view ending;  ///< of a file's name, with its dot
  std::string_view help;
  bool has_text = false;  ///< has a text beside its usual, binary form
  /// The whole file. Throws InputError if the surface does not fit the format.
  std::string (*write)(const Surface& surface, const Writing& writing);
};

std::span<const Format* const> formats();

/// The format of a name that ends so, in small letters or capitals; null if there is none.
const Format* format_of(std::string_view path);

}  // namespace csgsim::software::convert
