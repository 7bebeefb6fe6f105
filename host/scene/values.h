// Values and keys of scene files.
// Used by scene.h and schema.h.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace csgsim::scene {

/// Rows of colours; all rows have the same length.
using ColourTable = std::vector<std::vector<glm::dvec3>>;

/// A value of a scene file; a choice is stored as the index of its name.
using Value = std::variant<bool, std::int64_t, double, glm::dvec3, ColourTable>;

enum class ValueKind : std::uint8_t {
  boolean,
  integer,
  number,
  vector,        ///< three numbers
  colour,        ///< three numbers from 0 to 1
  colour_table,  ///< a list of rows, each a list of colours
  choice,        ///< one of `names`
};

/// One key of a section.
struct Key {
  std::string_view name;
  ValueKind kind = ValueKind::boolean;
  std::string_view unit;  ///< empty if the key has no unit
  double least = 0;       ///< minimum of an integer or number, or of each component of a vector
  double most = 0;
  std::string_view meaning;
  std::span<const std::string_view> names{};
};

struct KeyValue {
  Key key;
  std::optional<Value> value;  ///< empty if the key is not given
};

/// A table of a scene file: each key of its section, in order, with the given value or else the default.
using Values = std::vector<KeyValue>;

}  // namespace csgsim::scene
