#pragma once

#include <string>
#include <vector>

namespace csgsim::studies {

/// The files themselves, and of each folder, and those in it, all .csg, .scad and .jan, by name; a .scad beside the
/// .csg of its own name is left out. None is named twice. Throws InputError for a folder without any.
std::vector<std::string> corpus_files(const std::vector<std::string>& names);

}  // namespace csgsim::studies
