// Shards of studies, as read by gather and by a resumed shard: their rows in a table, as JSON and as plots with a
// complete layout.

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/plots/layout.h"
#include "sim/studies/accuracy/show.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/corpus/measure.h"
#include "sim/studies/explore/show.h"
#include "sim/studies/gather.h"
#include "sim/studies/rows_json.h"
#include "sim/studies/shard_file.h"
#include "sim/studies/subdivide/show.h"
#include "sim/studies/sweep/show.h"
#include "sim/studies/table.h"
#include "tests/fuzz/property.h"
#include "tests/fuzz/scratch_file.h"

namespace fs = std::filesystem;
namespace fuzz = csgsim::fuzz;
namespace plots = csgsim::plots;
namespace studies = csgsim::studies;

namespace {

void lay_out(const std::vector<plots::Plot>& all) {
  for (const plots::Plot& plot : all)
    std::visit([](const auto& content) { static_cast<void>(plots::lay_out(content)); }, plot.content);
}

void show(const std::vector<studies::ExploreRow>& rows) {
  std::vector<studies::ShownGroup> groups;
  for (studies::ExploreGroup& group : studies::groups_of(rows, studies::explore_axes()))
    groups.push_back({std::move(group), {}});
  lay_out(studies::plots_of_explore(groups));
  static_cast<void>(studies::explore_json("", rows, groups));
}

void show(const std::vector<studies::SweepRow>& rows) {
  static_cast<void>(studies::rows_json<studies::SweepRow>("title", rows));
  static_cast<void>(studies::wrong_pictures(rows));
  lay_out(studies::plots_of_sweep(rows, "model"));
}

void show(const std::vector<studies::ComparisonRow>& rows) {
  static_cast<void>(studies::rows_json<studies::ComparisonRow>("title", rows));
  lay_out(studies::plots_of_comparison(rows, {rows.front().point.width, rows.front().point.height}, "model"));
}

void show(const std::vector<studies::CorpusRow>& rows) {
  static_cast<void>(studies::rows_json<studies::CorpusRow>("title", rows));
  lay_out(studies::plots_of_corpus(rows));
}

void show(const std::vector<studies::SubdivideRow>& rows) {
  static_cast<void>(studies::rows_json<studies::SubdivideRow>("title", rows));
  lay_out(studies::plots_of_subdivision(rows, "model"));
}

void show(const std::vector<studies::Measurement>& rows) {
  static_cast<void>(studies::rows_json<studies::Measurement>("title", rows));
  static_cast<void>(studies::halvings(studies::pareto_front(rows)));
  static_cast<void>(studies::equally_accurate_facets(rows));
  lay_out(studies::plots_of_accuracy(rows, {"model"}));
}

/// Processes the rows like gather.
template <class Row>
void put(const studies::MergedShards& gathered, const fs::path& folder) {
  const studies::RowFormat format = studies::row_format<Row>();
  if (gathered.columns != format.columns) return;
  const fs::path path = folder / "table.csv";
  fs::remove(path);
  std::vector<Row> rows;
  for (const std::string& row : studies::Table(path, "title", format).put(gathered))
    rows.push_back(studies::from_line<Row>(row));
  fuzz::require(rows.size() == gathered.rows.size() && !rows.empty(), "a table has the gathered rows");
  try {
    show(rows);
    fuzz::require(studies::Table(path, "title", format).rows() == gathered.rows, "a table is read as written");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

/// Checks that a written shard is read unchanged.
void check_writing(const studies::ShardFile& file, const fs::path& folder) {
  fs::remove_all(folder);
  studies::ShardWriter writer(folder, file.header, file.command, file.columns);
  for (const studies::ShardLine& line : file.lines) writer.add(line);
  const std::vector<fs::path> files = studies::list_shard_files(folder, file.header);
  if (file.lines.empty()) return;
  fuzz::require(files.size() == 1, "a shard's file is found by its header");
  const studies::ShardFile again = studies::read_shard_file(files.front());
  fuzz::require(again.header == file.header && again.command == file.command && again.columns == file.columns &&
                    again.lines == file.lines,
                "a shard is read as written");
}

/// Whether the command's name, which is part of file names, is known to gather.
bool has_known_name(const studies::ShardFile& file) {
  const std::string& name = file.header.words.front();
  return name == "sweep" || name == "compare" || name == "accuracy" || name == "corpus" || name == "subdivide" ||
         name == "explore";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  static const fs::path out = folder.path() / "out";
  static const fs::path file = studies::shards_folder(out) / "shard.csv";
  fs::create_directories(file.parent_path());
  fuzz::write_scratch(file, fuzz::text_of(data, size));
  try {
    const studies::ShardFile shard = studies::read_shard_file(file);
    if (has_known_name(shard)) check_writing(shard, folder.path() / "again");
    const studies::MergedShards gathered = studies::merge_shards(std::span(&out, 1));
    if (gathered.missing > 0) return 0;
    put<studies::SweepRow>(gathered, folder.path());
    put<studies::ComparisonRow>(gathered, folder.path());
    put<studies::CorpusRow>(gathered, folder.path());
    put<studies::Measurement>(gathered, folder.path());
    put<studies::SubdivideRow>(gathered, folder.path());
    put<studies::ExploreRow>(gathered, folder.path());
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
  return 0;
}
