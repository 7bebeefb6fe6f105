#include "sim/studies/shard_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/session/options/usage.h"
#include "sim/studies/folder.h"

namespace csgsim::studies {

namespace {

namespace fs = std::filesystem;

/// Throws InputError if the file belongs to another study than the header.
void refuse_other_study(const ShardFile& file, const ShardHeader& header, const fs::path& folder) {
  if (file.header.words == header.words && file.header.shard == header.shard) return;
  throw InputError(fmt::format("{}: holds a shard of another study, {}; choose another folder with -o, or delete {}",
                               file.path.native(), fmt::join(file.header.words, " "), shards_folder(folder).native()));
}

}  // namespace

ShardRun::ShardRun(fs::path folder, ShardHeader header, std::vector<std::string> command, std::string columns)
    : folder_(std::move(folder)),
      header_(std::move(header)),
      writer_(folder_, header_, std::move(command), std::move(columns)) {
  if (folder_.empty()) throw session::UsageError("--output", "a shard needs a folder; specify one");
  std::set<std::size_t> known;
  std::set<std::string> changed;
  for (const fs::path& path : list_shard_files(folder_, header_)) {
    const ShardFile file = read_shard_file(path);
    refuse_other_study(file, header_, folder_);
    if (file.header == header_) {
      for (const ShardLine& line : file.lines) known.insert(line.point);
      continue;
    }
    for (std::string& name : changed_inputs(file.header.inputs, header_.inputs)) changed.insert(std::move(name));
    std::error_code error;
    fs::remove(path, error);
    if (error)
      throw InputError(fmt::format("{} is out of date and cannot be deleted ({})", path.native(), error.message()));
  }
  warn_stale_rows(shards_folder(folder_), changed);
  const std::vector<unsigned> shard_of = assign_shards(header_.points, header_.shard.count);
  for (std::size_t i = 0; i < shard_of.size(); ++i) {
    if (shard_of[i] != header_.shard.number) continue;
    ++points_;
    if (!known.contains(i)) missing_.push_back(i);
  }
}

void ShardRun::print() const {
  fmt::print("shard {}: {} of the {} points are in {}, {} of them measured by this run\n", to_text(header_.shard),
             points_, header_.points, printable(shards_folder(folder_).native()), missing_.size());
}

}  // namespace csgsim::studies
