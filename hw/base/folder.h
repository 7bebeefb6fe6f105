// Creates folders.
// Used by OutputFolder and sim/studies.
#pragma once

#include <filesystem>

namespace csgsim {

/// Creates the folder and its missing parents. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace csgsim
