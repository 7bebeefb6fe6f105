#pragma once

#include <filesystem>
#include <string_view>

namespace csgsim::app {

/// Does the path's name end so, in small letters or capitals?
bool ends_in(const std::filesystem::path& path, std::string_view ending);

inline bool is_model(const std::filesystem::path& path) { return ends_in(path, ".csg"); }
inline bool is_program(const std::filesystem::path& path) { return ends_in(path, ".csgt"); }

}  // namespace csgsim::app
