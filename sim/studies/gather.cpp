#include "sim/studies/gather.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <utility>

namespace csgsim::studies {

namespace {

namespace fs = std::filesystem;

std::string describe_shard(const ShardFile& file) {
  return fmt::format("shard {} ({})", to_text(file.header.shard), file.path.native());
}

/// Throws InputError if the file's header differs from that of the first file.
void refuse_other_study(const ShardFile& first, const ShardFile& file) {
  const auto refuse = [&](const std::string& why, const std::string& fix) {
    throw InputError(fmt::format("{} and {} are {}; {}", describe_shard(file), describe_shard(first), why, fix));
  };
  const ShardHeader& a = first.header;
  const ShardHeader& b = file.header;
  if (a.words != b.words)
    refuse(fmt::format("of different commands: {} and {}", fmt::join(b.words, " "), fmt::join(a.words, " ")),
           "gather one study at a time");
  if (a.shard.count != b.shard.count)
    refuse(fmt::format("of {} and of {} shards", b.shard.count, a.shard.count), "delete one of the two sets of files");
  std::vector<std::string> changed = changed_inputs(a.inputs, b.inputs);
  if (a.points != b.points) changed.emplace_back("the number of points");
  if (first.columns != file.columns) changed.emplace_back("the columns");
  if (!changed.empty())
    refuse(fmt::format("not of the same study: {} changed between them", fmt::join(changed, " and ")),
           "run the earlier shards again");
}

/// Checks that each shard is in one folder only.
class Folders {
 public:
  void add(const Shard& shard, std::size_t study, std::span<const fs::path> studies) {
    const auto [known, is_new] = study_of_.emplace(shard.number, study);
    if (is_new || known->second == study) return;
    throw InputError(fmt::format("shard {} is in {} and in {}; omit one of them", to_text(shard),
                                 studies[known->second].native(), studies[study].native()));
  }

 private:
  std::map<unsigned, std::size_t> study_of_;
};

/// Several processes may have measured a point of one shard; their results must agree.
void add_lines(const ShardFile& file, const std::vector<unsigned>& shard_of, MergedShards& gathered) {
  for (const ShardLine& line : file.lines) {
    if (shard_of[line.point] != file.header.shard.number)
      throw InputError(fmt::format("{}: point {} belongs to shard {}/{}; delete the file and run its shard again",
                                   file.path.native(), line.point, shard_of[line.point], gathered.shards));
    std::string& row = gathered.rows[line.point];
    if (!row.empty() && row != line.row)
      throw InputError(
          fmt::format("{} and {} have different results for point {}, because of a faulty computer, an error in "
                      "csgsim, or a changed file: delete both and run the shard again",
                      gathered.measured[line.point].native(), file.path.native(), line.point));
    row = line.row;
    gathered.measured[line.point] = file.path;
  }
}

void count_missing(const std::vector<unsigned>& shard_of, MergedShards& gathered) {
  std::set<unsigned> unfinished;
  for (std::size_t i = 0; i < gathered.rows.size(); ++i) {
    if (!gathered.rows[i].empty()) continue;
    ++gathered.missing;
    unfinished.insert(shard_of[i]);
  }
  gathered.unfinished.assign(unfinished.begin(), unfinished.end());
}

}  // namespace

MergedShards merge_shards(std::span<const fs::path> studies) {
  Folders folders;
  std::vector<ShardFile> files;
  for (std::size_t study = 0; study < studies.size(); ++study) {
    for (const fs::path& path : list_shard_files(studies[study])) {
      files.push_back(read_shard_file(path));
      refuse_other_study(files.front(), files.back());
      folders.add(files.back().header.shard, study, studies);
    }
  }
  if (files.empty())
    throw InputError(
        fmt::format("{}: contains no shard of a study; run the shards first", shards_folder(studies.front()).native()));
  const ShardHeader& header = files.front().header;
  MergedShards gathered;
  gathered.shards = header.shard.count;
  gathered.inputs = header.inputs;
  gathered.words = header.words;
  gathered.columns = files.front().columns;
  gathered.first = files.front().path;
  gathered.rows.resize(header.points);
  gathered.measured.resize(header.points);
  const std::vector<unsigned> shard_of = assign_shards(header.points, header.shard.count);
  for (const ShardFile& file : files) {
    add_lines(file, shard_of, gathered);
    if (!file.command.empty())
      gathered.commands[file.header.shard.number] = {file.path, file.header, file.command, file.columns, {}};
  }
  count_missing(shard_of, gathered);
  return gathered;
}

}  // namespace csgsim::studies
