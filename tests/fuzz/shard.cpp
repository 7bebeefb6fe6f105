// Shards of studies, as gather and a shard that goes on read them: their rows, in a table, as JSON and as plots with
// everything in its place.

#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/plots/layout.h"
#include "sim/study/comparison.h"
#include "sim/study/corpus.h"
#include "sim/study/gather.h"
#include "sim/study/measure.h"
#include "sim/study/pareto.h"
#include "sim/study/plots.h"
#include "sim/study/shard_file.h"
#include "sim/study/sweep.h"
#include "sim/study/sweep_plots.h"
#include "tests/fuzz/property.h"
#include "tests/fuzz/scratch_file.h"

namespace fs = std::filesystem;
namespace fuzz = csgsim::fuzz;
namespace plots = csgsim::plots;
namespace study = csgsim::study;

namespace {

void lay_out(const std::vector<plots::Plot>& all) {
  for (const plots::Plot& plot : all)
    std::visit([](const auto& content) { static_cast<void>(plots::laid_out(content)); }, plot.content);
}

void show(const std::vector<study::SweepRow>& rows) {
  static_cast<void>(study::points_json("title", rows));
  static_cast<void>(study::wrong_pictures(rows));
  lay_out(study::plots_of_sweep(rows, "model"));
}

void show(const std::vector<study::ComparisonRow>& rows) {
  static_cast<void>(study::points_json("title", rows));
  lay_out(study::plots_of_comparison(rows, {rows.front().point.width, rows.front().point.height}, "model"));
}

void show(const std::vector<study::CorpusRow>& rows) {
  static_cast<void>(study::corpus_json("title", rows));
  lay_out(study::plots_of_corpus(rows));
}

void show(const std::vector<study::Measurement>& rows) {
  static_cast<void>(study::points_json("title", rows));
  static_cast<void>(study::halvings(study::pareto_front(rows)));
  static_cast<void>(study::facets_as_right(rows));
  lay_out(study::plots_of_accuracy(rows, {"model"}));
}

/// What gather does with the rows.
template <class Row>
void put(const study::Gathered& gathered, const fs::path& folder) {
  if (gathered.columns != study::header_of<Row>()) return;
  const fs::path path = folder / "table.csv";
  fs::remove(path);
  study::Table<Row> table(path, "title");
  const std::vector<Row> rows = study::put_rows(gathered, path, table);
  fuzz::require(rows.size() == gathered.rows.size() && !rows.empty(), "a table has the rows that were gathered");
  try {
    show(rows);
    fuzz::require(study::Table<Row>(path, "title").rows().size() == rows.size(), "a table is read as written");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

/// What the shard has measured is what is read of another one that says the same.
void check_writing(const study::ShardFile& file, const fs::path& folder) {
  fs::remove_all(folder);
  study::ShardWriter writer(folder, file.header, file.columns);
  for (const study::ShardLine& line : file.lines) writer.add(line);
  const std::vector<fs::path> files = study::shard_files(folder, file.header);
  if (file.lines.empty()) return;
  fuzz::require(files.size() == 1, "a shard's file is found by its header");
  const study::ShardFile again = study::read_shard_file(files.front());
  fuzz::require(again.header == file.header && again.columns == file.columns && again.lines == file.lines,
                "a shard is read as written");
}

/// Its command's name, which is part of the names of files: gather knows those that there are.
bool has_known_name(const study::ShardFile& file) {
  const std::string& name = file.header.words.front();
  return name == "sweep" || name == "compare" || name == "accuracy" || name == "corpus";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  static const fs::path out = folder.path() / "out";
  static const fs::path file = study::shards_folder(out) / "shard.csv";
  fs::create_directories(file.parent_path());
  fuzz::write_scratch(file, fuzz::text_of(data, size));
  try {
    const study::ShardFile shard = study::read_shard_file(file);
    if (has_known_name(shard)) check_writing(shard, folder.path() / "again");
    const study::Gathered gathered = study::gather(std::span(&out, 1));
    if (gathered.missing > 0) return 0;
    put<study::SweepRow>(gathered, folder.path());
    put<study::ComparisonRow>(gathered, folder.path());
    put<study::CorpusRow>(gathered, folder.path());
    put<study::Measurement>(gathered, folder.path());
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error);
  }
  return 0;
}
