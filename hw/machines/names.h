#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::machines {

// What files of figures describe is named NAME+KEY=VALUE+KEY=VALUE: NAME comes with csgsim, or is a file, which ends in
// .toml; then figures that are changed.

/// The file; empty where the name is none.
std::string_view file_of(std::string_view said);

/// What comes with csgsim, or the file.
std::string_view base_of(std::string_view said);

/// KEY=VALUE of each change.
std::vector<std::string> changes_of(std::string_view said);

/// `+KEY=VALUE` of each figure that is other than the original's.
std::string name_of_edits(std::span<const Figure> figures, std::span<const Figure> original);

}  // namespace csgsim::machines
