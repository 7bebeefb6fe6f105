// Names with parameter changes.
// Used by catalogue.h, hw/kinds and sim/studies.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::machines {

// Machines, processors and processes are named NAME+KEY=VALUE+KEY=VALUE: NAME is built in, or a file that ends in
// .toml; changed parameters follow.

/// The file that a name begins with; empty if it names no file.
std::string_view file_of(std::string_view spec);

/// The name without changes: a built-in name or a file.
std::string_view base_name(std::string_view spec);

/// The changes in the name, each as KEY=VALUE.
std::vector<std::string> changes_of(std::string_view spec);

/// Suffix of an edited machine's name: `+KEY=VALUE` for each parameter of `figures` whose value in `original_figures`
/// differs.
std::string edits_suffix(std::span<const Figure> figures, std::span<const Figure> original_figures);

}  // namespace csgsim::machines
