// Loads the module of picture formats on demand.
// Used by encode.cpp.
#pragma once

#include <filesystem>

#include "sim/pictures/module.h"

namespace csgsim::pictures {

/// Starts opening the module on a separate thread, unless already started. Throws InputError, which begins with the
/// picture's path, if the module's file does not exist.
void start_opening_module(const std::filesystem::path& picture_path);

/// Waits until the module is open and returns it. Throws InputError as start_opening_module() does, and if the module
/// cannot be opened.
const Module& wait_for_module(const std::filesystem::path& picture_path);

}  // namespace csgsim::pictures
