#include "sim/app/studies/shard_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/usage.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

/// Throws InputError if the file is of another study than the header.
void refuse_other_study(const study::ShardFile& file, const study::ShardHeader& header, const fs::path& folder) {
  if (file.header.words == header.words && file.header.shard == header.shard) return;
  throw InputError(
      fmt::format("{}: holds a shard of another study, {}; give this one a folder of its own with -o, or delete {}",
                  file.path.native(), printable(fmt::format("{}", fmt::join(file.header.words, " "))),
                  study::shards_folder(folder).native()));
}

}  // namespace

void add_shard(Command& command, std::optional<study::Shard>& shard) {
  command.read_option(
      "--shard",
      [&shard](const std::string& text) {
        try {
          shard = study::parse_shard(text);
        } catch (const InputError& error) {
          throw UsageError("--shard", error.what());
        }
      },
      "Measure only the k-th of n shares of the points, as 3/16, into FOLDER/shards; csgsim gather joins them");
}

void refuse_page(const Command& command) {
  const std::vector<GivenOption> given = command.given();
  if (std::ranges::find(given, "report", &GivenOption::name) == given.end()) return;
  throw UsageError("--report", "a shard has no page; csgsim gather writes it from all of them");
}

std::vector<std::string> with_words(const std::vector<std::string>& command, const std::vector<std::string>& more) {
  std::vector<std::string> words = command;
  words.insert(words.begin() + 1, more.begin(), more.end());
  return words;
}

ShardRun::ShardRun(fs::path folder, study::ShardHeader header, std::string columns)
    : folder_(std::move(folder)), header_(std::move(header)), writer_(folder_, header_, std::move(columns)) {
  if (folder_.empty()) throw UsageError("--output", "the name is empty; name the folder");
  std::set<std::size_t> known;
  std::set<std::string> changed;
  for (const fs::path& path : study::shard_files(folder_, header_)) {
    const study::ShardFile file = study::read_shard_file(path);
    refuse_other_study(file, header_, folder_);
    if (file.header == header_) {
      for (const study::ShardLine& line : file.lines) known.insert(line.point);
      continue;
    }
    for (std::string& name : study::differences(file.header.inputs, header_.inputs)) changed.insert(std::move(name));
    std::error_code error;
    fs::remove(path, error);
    if (error)
      throw InputError(fmt::format("{}: is out of date and cannot be deleted ({})", path.native(), error.message()));
  }
  tell_stale(study::shards_folder(folder_), changed);
  const std::vector<unsigned> shard_of = study::shard_of_each(header_.points, header_.shard.count);
  for (std::size_t i = 0; i < shard_of.size(); ++i) {
    if (shard_of[i] != header_.shard.number) continue;
    ++points_;
    if (!known.contains(i)) missing_.push_back(i);
  }
}

void ShardRun::print() const {
  fmt::print("shard {}: {} of the {} points are in {}, {} of them measured now\n", study::to_text(header_.shard),
             points_, header_.points, printable(study::shards_folder(folder_).native()), missing_.size());
}

}  // namespace csgsim::app
