// File formats of surfaces and of flat shapes.
// Used by sim/app.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/software/convert/surface.h"

namespace csgsim::software::convert {

/// Options for writing a file.
struct WriteOptions {
  bool is_text = false;  ///< text form, if the format also has a binary form
};

/// A row of the table of formats; each has a separate source file.
struct Format {
  std::string_view ending;  ///< file name extension, including the dot
  std::string_view help;
  bool is_flat = false;    ///< for flat models only; all other formats are for solids only
  bool is_binary = false;  ///< whether its usual form is binary
  bool has_text = false;   ///< whether a text form exists in addition to the binary form
  /// Returns the content of the file. A flat format receives the surface of the plates (flat_rounds.h). Throws
  /// InputError if the format cannot represent the surface.
  std::string (*write)(const Surface& surface, const WriteOptions& writing);

  [[nodiscard]] std::string_view name() const { return ending.substr(1); }
};

std::span<const Format* const> formats();

/// The format for a file name, by its extension in upper or lower case; nullptr if there is none.
const Format* format_of(std::string_view path);

}  // namespace csgsim::software::convert
