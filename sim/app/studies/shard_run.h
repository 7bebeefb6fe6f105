#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "sim/app/command_line.h"
#include "sim/app/options.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/sweep_progress.h"
#include "sim/app/version.h"
#include "sim/study/hash.h"
#include "sim/study/inputs.h"
#include "sim/study/shard_file.h"
#include "sim/study/table.h"

namespace csgsim::app {

/// Adds --shard to a study.
void add_shard(Command& command, std::optional<study::Shard>& shard);

/// Throws UsageError for a page, which shards do not have.
void refuse_page(const Command& command);

/// The command with these words after its name, before those that it was given.
std::vector<std::string> with_words(const std::vector<std::string>& command, const std::vector<std::string>& more);

/// A process's share of a study.
class ShardRun {
 public:
  /// Reads what was measured before; what that was measured from and has changed since is told, and measured anew.
  /// Throws InputError if the folder holds another study.
  ShardRun(std::filesystem::path folder, study::ShardHeader header, std::string columns);

  /// Numbers of the shard's points that have to be measured.
  [[nodiscard]] const std::vector<std::size_t>& missing() const { return missing_; }

  /// Of all points of the shard.
  [[nodiscard]] std::size_t points() const { return points_; }

  void add(std::size_t point, std::string row) { writer_.add({point, std::move(row)}); }

  /// Says on standard output what is there now.
  void print() const;

 private:
  std::filesystem::path folder_;
  study::ShardHeader header_;
  study::ShardWriter writer_;
  std::size_t points_ = 0;
  std::vector<std::size_t> missing_;
};

/// Of all points together.
template <class Wanted>
study::Inputs inputs_of(const std::vector<Wanted>& wanted) {
  study::Hash models;
  study::Hash machines;
  for (const Wanted& one : wanted) {
    models.add(one.inputs.model_hash + "\n");
    machines.add(one.inputs.machine_hash + "\n");
  }
  return {models.text(), machines.text(), version_and_build()};
}

/// Does the shard of a study whose points are `wanted`, no two of them the same; csgsim gather does the rest.
/// `measure(numbers, finished)` calls finished(row) for each of the points with these numbers, in any order.
template <class Row, class Wanted, class Measure>
void measure_shard(const Command& command, const std::filesystem::path& folder, const study::Shard& shard,
                   const std::vector<Wanted>& wanted, const std::string& progress, Measure measure_points) {
  refuse_page(command);
  if (wanted.size() > study::most_points)
    throw InputError(fmt::format("{} points are too many to be shared out, {} at most; take several studies",
                                 wanted.size(), study::most_points));
  ShardRun run(folder, {shard, wanted.size(), inputs_of(wanted), study_words(command)}, study::header_of<Row>());
  {
    SweepProgress shown(run.points(), run.points() - run.missing().size(), shows_progress(progress));
    measure_points(run.missing(), [&](const Row& row) {
      const auto point =
          std::find_if(wanted.begin(), wanted.end(), [&](const Wanted& one) { return measures(row, one); });
      if (point == wanted.end()) throw std::logic_error("a point was measured that was not wanted");
      run.add(static_cast<std::size_t>(point - wanted.begin()), study::to_line(row));
      shown.done();
    });
  }
  run.print();
}

}  // namespace csgsim::app
