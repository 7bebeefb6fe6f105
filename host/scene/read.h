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

/// What is wrong with a key or value that was not in the file but given as `KEY=VALUE`.
class SetError : public InputError {
 public:
  using InputError::InputError;
};

/// A section, or a table of its list.
struct SectionValues {
  std::string_view name;
  bool is_of_list = false;
  Values values;
};

/// Reads a scene (TOML); `file` is its name in messages, `effects` the sections of the effects that there are, with
/// names `effects.NAME`. Then each of `sets`, KEY=VALUE as in `lights.0.direction=[0, 0, -1]`, in order: a key that the
/// text has too is replaced; the number after a list's last adds a table to it. Throws InputError with
/// file:line:column, or SetError with the KEY=VALUE. `values`, if not null, gets what holds: the common sections that
/// are no lists, and of the others those that are there and not off.
Scene read_scene(std::string_view text, std::string_view file, std::span<const std::string> sets,
                 std::span<const Section> effects, std::vector<SectionValues>* values = nullptr);

}  // namespace csgsim::scene
