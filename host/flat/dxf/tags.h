// Reader of the groups of an ASCII DXF file.
// Used by dxf.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace csgsim::flat::dxf {

/// A group: a code and its value, on one line each.
struct Tag {
  int code = 0;
  std::string_view value;  ///< excludes leading and trailing white space
  std::size_t line = 0;    ///< line of the value, from 1
};

/// Reads the groups of a file one after another.
class Tags {
 public:
  explicit Tags(std::string_view bytes) : rest_(bytes) {}

  /// The next group; empty at the end of the file. Throws InputError for a code that is not a number.
  std::optional<Tag> next();

 private:
  std::string_view take_line();

  std::string_view rest_;
  std::size_t line_ = 0;
};

/// Both functions throw InputError for a value that is not a number or not finite.
double parse_real(const Tag& tag);
int parse_integer(const Tag& tag);

}  // namespace csgsim::flat::dxf
