#include "hw/base/file_roles.h"

#include <sys/stat.h>

#include <string>
#include <tuple>
#include <vector>

#include "hw/base/output_file.h"
#include "hw/base/standard_streams.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

/// Identifies a file. A file that does not exist yet is identified by its folder and name.
struct Identity {
  dev_t device = 0;
  ino_t inode = 0;
  std::string name;
  bool is_device = false;

  bool operator==(const Identity& other) const {
    return std::tie(device, inode, name) == std::tie(other.device, other.inode, other.name);
  }
};

/// Empty if not even the folder exists.
std::optional<Identity> identity(const fs::path& path) {
  struct stat status {};
  if (is_standard_output(path)) return Identity{0, 0, std::string(standard_stream), false};
  if (::stat(path.c_str(), &status) == 0) return Identity{status.st_dev, status.st_ino, "", S_ISCHR(status.st_mode)};
  const fs::path place = resolve_links(path);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (::stat(folder.c_str(), &status) != 0) return std::nullopt;
  return Identity{status.st_dev, status.st_ino, place.filename().native(), false};
}

struct Seen {
  const fs::path* path;
  Identity identity;
  bool is_input;
};

}  // namespace

std::optional<Clash> find_clash(std::span<const fs::path> inputs, std::span<const fs::path> outputs) {
  std::vector<Seen> seen;
  for (const fs::path& input : inputs) {
    if (input.native() == standard_stream) continue;
    if (const auto known = identity(input)) seen.push_back({&input, *known, true});
  }
  for (const fs::path& output : outputs) {
    const std::optional<Identity> known = identity(output);
    if (!known || known->is_device) continue;
    for (const Seen& one : seen) {
      if (one.identity == *known) return Clash{output, *one.path, one.is_input};
    }
    seen.push_back({&output, *known, false});
  }
  return std::nullopt;
}

}  // namespace csgsim
