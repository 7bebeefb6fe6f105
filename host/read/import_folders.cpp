#include "host/read/import_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "hw/base/error.h"

namespace csgsim::read {

namespace {

namespace fs = std::filesystem;

/// An absolute path without `.`, `..` and a trailing slash.
fs::path normalized(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

/// Whether the path is lexically in the folder; both must be absolute.
bool is_in(const fs::path& path, const fs::path& folder) {
  const fs::path below = path.lexically_relative(folder);
  return !below.empty() && *below.begin() != "..";
}

}  // namespace

ImportFolders::ImportFolders(const fs::path& model_folder, const fs::path& additional_folder)
    : folders_{model_folder.empty() ? fs::path(".") : model_folder} {
  if (!additional_folder.empty()) folders_.push_back(additional_folder);
}

bool ImportPlace::exists() const {
  std::error_code error;
  return fs::status(path, error).type() != fs::file_type::not_found;
}

std::vector<ImportPlace> ImportFolders::candidate_places(std::string_view name) const {
  std::vector<ImportPlace> places;
  for (const fs::path& folder : folders_) {
    const fs::path place = (folder / name).lexically_normal();
    const auto holds_it = [&](const fs::path& one) { return is_in(normalized(place), normalized(one)); };
    if (std::ranges::find(places, place, &ImportPlace::path) != places.end()) continue;
    places.push_back({place, std::ranges::any_of(folders_, holds_it)});
  }
  return places;
}

bool ImportFolders::contains(const Descriptor& file) const {
  std::error_code error;
  const fs::path place = fs::read_symlink(fmt::format("/proc/self/fd/{}", file.number()), error);
  if (error) throw InputError("/proc does not show the targets of links (" + error.message() + "); mount it");
  return std::ranges::any_of(folders_, [&](const fs::path& folder) {
    std::error_code missing;
    const fs::path real = fs::canonical(folder, missing);
    return !missing && is_in(place, real);
  });
}

}  // namespace csgsim::read
