#pragma once

#include <filesystem>
#include <string>

namespace csgsim::studies {

/// A file's name without its ending, of at most so many bytes that endings and numbers fit behind it.
std::string plot_stem(const std::filesystem::path& model);

}  // namespace csgsim::studies
