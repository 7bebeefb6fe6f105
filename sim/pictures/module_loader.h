// Loads the module of picture formats on demand.
// Used by encode.cpp.
#pragma once

#include <filesystem>

#include "sim/pictures/module.h"

namespace csgsim::pictures {

/// Starts opening the module on a separate thread, unless already started. Throws InputError, which begins with the
/// picture's path, if its file does not exist.
void begin_to_open_module(const std::filesystem::path& picture);

/// The opened module. Throws InputError as above, and if it cannot be opened.
const Module& opened_module(const std::filesystem::path& picture);

}  // namespace csgsim::pictures
