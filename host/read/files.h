#pragma once

#include <filesystem>

#include "host/read/arguments.h"

namespace csgsim::read {

/// The file that a node names by its argument `file`, see Source::file(). Throws InputError if it names none.
std::filesystem::path file_of(const Arguments& arguments);

/// The ending of its name in small letters, as `.stl`.
std::string ending_of(const std::filesystem::path& path);

}  // namespace csgsim::read
