#pragma once

#include <filesystem>

namespace csgsim {

/// Makes a folder, with those that it is in, where there is none. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace csgsim
