#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/toml_text.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Changes of figures, which a file of figures was given.
struct ChangesMade {
  std::vector<std::string> keys;
  std::string said;  ///< the file and the changes, for messages
};

/// Gives each figure that a change, KEY=VALUE, names that value, which is assumed from then on. Throws ChangeError.
ChangesMade make_changes(toml::table& root, std::span<const std::string> changes, std::string_view file);

/// What tells the changed thing from others: `+KEY=VALUE` of each figure that was changed, once, with the value that it
/// has.
std::string name_of_changes(std::span<const std::string> keys, std::span<const Figure> figures);

/// What a description describes, with the changes: `read(root, said)` makes it, and has the errors tell what was said
/// where that is not empty. What it makes has a `name`, which tells the changes, and `figures`.
template <class Read>
auto read_changed(std::string_view text, std::string_view file, std::span<const std::string> changes, Read read) {
  toml::table root = parse_toml(text, file);
  auto described = read(root, std::string());
  if (changes.empty()) return described;
  const ChangesMade made = make_changes(root, changes, file);
  described = read(root, made.said);
  described.name += name_of_changes(made.keys, described.figures);
  return described;
}

}  // namespace csgsim::machines
