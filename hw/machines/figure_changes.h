// Applies KEY=VALUE changes to descriptions.
// Used by hw/process and hw/processors.
#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/toml_text.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Changes of parameters that were applied to a description.
struct AppliedChanges {
  std::vector<std::string> keys;
  std::string spec;  ///< the file and the changes, for messages
};

/// Applies changes of the form KEY=VALUE; the provenance of the changed values becomes `assumed`. Throws ChangeError.
AppliedChanges apply_changes(toml::table& root, std::span<const std::string> changes, std::string_view file);

/// Suffix of a changed description's name: `+KEY=VALUE` for each changed parameter, once, with its final value.
std::string changes_suffix(std::span<const std::string> keys, std::span<const Figure> figures);

/// Reads a description with changes. `read(root, spec)` converts the table; a non-empty `spec` names the file and
/// changes for error texts. The result must have a `name`, to which the changes are appended, and `figures`.
template <class Read>
auto read_changed(std::string_view text, std::string_view file, std::span<const std::string> changes, Read read) {
  toml::table root = parse_toml(text, file);
  auto described = read(root, std::string());
  if (changes.empty()) return described;
  const AppliedChanges made = apply_changes(root, changes, file);
  described = read(root, made.spec);
  described.name += changes_suffix(made.keys, described.figures);
  return described;
}

}  // namespace csgsim::machines
