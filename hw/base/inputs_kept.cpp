#include "hw/base/inputs_kept.h"

#include <mutex>
#include <set>
#include <system_error>
#include <vector>

#include "hw/base/file_roles.h"

namespace csgsim {

namespace {

namespace fs = std::filesystem;

struct Kept {
  std::mutex mutex;
  bool is_on = false;
  std::set<fs::path> files;  ///< absolute paths
};

Kept& kept() {
  static Kept one;
  return one;
}

}  // namespace

void protect_inputs() {
  const std::lock_guard lock(kept().mutex);
  kept().is_on = true;
}

void record_input(const fs::path& file) {
  const std::lock_guard lock(kept().mutex);
  std::error_code error;
  if (kept().is_on) kept().files.insert(fs::absolute(file, error));
}

std::optional<fs::path> recorded_input(const fs::path& output) {
  const std::lock_guard lock(kept().mutex);
  const std::vector<fs::path> files(kept().files.begin(), kept().files.end());
  const std::optional<Clash> clash = find_clash(files, std::span(&output, 1));
  return clash ? std::optional(clash->other) : std::nullopt;
}

}  // namespace csgsim
