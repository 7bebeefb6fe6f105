// The models of a corpus.
// Used by csgsim corpus.
#pragma once

#include <string>
#include <vector>

namespace csgsim::studies {

/// The named files, and all .csg, .scad and .jan files of the named folders and their subfolders, sorted by name. A
/// .scad file is omitted if a .csg file with the same name exists. No file is listed twice. Throws InputError for a
/// folder without models.
std::vector<std::string> corpus_files(const std::vector<std::string>& names);

}  // namespace csgsim::studies
