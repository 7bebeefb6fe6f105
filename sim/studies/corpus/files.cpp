#include "sim/studies/corpus/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "hw/base/error.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"

namespace csgsim::studies {

namespace {

namespace fs = std::filesystem;

bool is_source_of(const fs::path& file, const std::vector<fs::path>& files) {
  return session::has_extension(file, ".scad") &&
         std::ranges::find(files, fs::path(file).replace_extension(".csg")) != files.end();
}

/// Meshes in a folder are usually imports of its models.
bool is_listed(const fs::path& file) { return session::has_model_name(file) && !session::has_mesh_name(file); }

std::vector<fs::path> find_models(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(folder, error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry->is_regular_file() && is_listed(entry->path())) files.push_back(entry->path());
  }
  if (error) throw InputError(fmt::format("{}: cannot be read ({})", folder.native(), error.message()));
  std::ranges::sort(files);
  std::vector<fs::path> models;
  for (const fs::path& file : files) {
    if (!is_source_of(file, files)) models.push_back(file);
  }
  if (models.empty())
    throw InputError(folder.native() + ": contains no .csg, .scad or .jan file; specify another folder");
  return models;
}

}  // namespace

std::vector<std::string> corpus_files(const std::vector<std::string>& names) {
  std::vector<std::string> models;
  const auto add = [&](const std::string& model) {
    if (std::ranges::find(models, model) == models.end()) models.push_back(model);
  };
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      add(name);
      continue;
    }
    for (const fs::path& file : find_models(name)) add(file.native());
  }
  return models;
}

}  // namespace csgsim::studies
