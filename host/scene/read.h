// Reader of scene files.
// Used by set.cpp and sim/session.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/schema.h"
#include "hw/base/error.h"

namespace csgsim::scene {

/// An error in a key or value given as `KEY=VALUE` instead of in the file.
class SetError : public InputError {
 public:
  using InputError::InputError;
};

/// The values of a section, or of one table of a list section.
struct SectionValues {
  std::string_view name;
  bool is_list_entry = false;
  Values values;
};

/// Reads a scene (TOML). `file` is its name in messages; `effects` are the sections of the available effects, named
/// `effects.NAME`. Then applies each of `assignments` in order, as KEY=VALUE, for example `lights.0.direction=[0, 0,
/// -1]`. An existing key is replaced, and an index one past the last table of a list adds a table. Throws InputError
/// with file:line:column, or SetError with the KEY=VALUE. If `values` is not null, it receives the values in effect:
/// those of the common sections that are not lists, and of other sections that are present and not switched off.
Scene read_scene(std::string_view text, std::string_view file, std::span<const std::string> assignments,
                 std::span<const Section> effects, std::vector<SectionValues>* values = nullptr);

}  // namespace csgsim::scene
