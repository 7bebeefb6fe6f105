#pragma once

#include <filesystem>

#include "sim/pictures/module.h"

namespace csgsim::pictures {

/// Begins to open the module on a thread of its own, if that has not begun. Throws InputError, which begins with the
/// picture's path, if there is no such file.
void begin_to_open_module(const std::filesystem::path& picture);

/// The module, when it is open. Throws InputError as above, and if it cannot be opened.
const Module& opened_module(const std::filesystem::path& picture);

}  // namespace csgsim::pictures
