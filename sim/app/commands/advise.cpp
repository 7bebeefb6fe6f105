#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/memory.h"
#include "sim/app/options.h"
#include "sim/app/studies/advise_options.h"
#include "sim/app/studies/advise_report.h"
#include "sim/app/studies/study_files.h"
#include "sim/app/studies/sweep_progress.h"
#include "sim/study/advice_plot.h"
#include "sim/study/plot_stem.h"
#include "sim/study/table.h"

namespace csgsim::app {

namespace {

using study::AdvicePoint;
using study::AdviceRow;
using Rows = std::vector<AdviceRow>;
using Table = study::Table<AdviceRow>;

/// What was measured serves other wishes and other ranges too.
std::string title_of(const AdviseOptions& options, const Command& command) {
  std::set<std::string> varied;
  for (std::string& name : own_options()) {
    if (name != "machine" && name != "set") varied.insert(std::move(name));
  }
  return study_title(command, varied) + " of " +
         escaped(std::filesystem::path(options.model.model).filename().native());
}

/// Rows as they come, kept in a file if there is one.
class Kept {
 public:
  explicit Kept(Table* table) : table_(table) {
    if (table_ == nullptr) return;
    for (const AdviceRow& row : table_->rows()) rows_.insert_or_assign(row.point, row);
  }

  [[nodiscard]] bool has(const AdvicePoint& point) const { return rows_.contains(point); }
  [[nodiscard]] const AdviceRow& at(const AdvicePoint& point) const { return rows_.at(point); }

  void add(AdviceRow row) {
    if (table_ != nullptr) pending_.push_back(row);
    rows_.insert_or_assign(row.point, std::move(row));
    if (pending_.size() == most_pending) write();
  }

  /// To the disk.
  void write() {
    if (table_ != nullptr) table_->add(std::exchange(pending_, {}));
  }

  /// The rows of these points in their order; the file has them so too, before what it has of other points.
  Rows in_order(std::span<const AdvicePoint> points) {
    Rows rows;
    for (const AdvicePoint& point : points) rows.push_back(rows_.at(point));
    if (table_ == nullptr) return rows;
    const std::set<AdvicePoint> asked(points.begin(), points.end());
    Rows all = rows;
    for (const AdviceRow& row : table_->rows()) {
      if (!asked.contains(row.point)) all.push_back(row);
    }
    table_->replace(std::move(all));
    return rows;
  }

 private:
  /// A line at a time would wait for the disk most of the time.
  static constexpr std::size_t most_pending = 8;

  Table* table_;
  std::map<AdvicePoint, AdviceRow> rows_;
  Rows pending_;
};

Rows complete(const AdviseOptions& options, const AdviceQuestion& question, Table* table) {
  Kept kept(table);
  std::vector<AdvicePoint> missing;
  for (const AdvicePoint& point : question.points) {
    if (!kept.has(point)) missing.push_back(point);
  }
  SweepProgress progress(question.points.size(), question.points.size() - missing.size(),
                         shows_progress(options.progress), options.threads);
  with_memory_for_threads(options.threads, "choices", [&] {
    study::measure_advice(question.job, missing, options.threads, [&](AdviceRow row) {
      kept.add(std::move(row));
      progress.done();
    });
  });
  kept.write();
  return kept.in_order(question.points);
}

/// What is recommended is drawn again, each with its own strategy, colouring and ALU.
void check_by_drawing(const study::AdviceJob& job, const AdviceRow& row, bool has_read_rows) {
  if (study::draw_advice(job, row.point) == row) return;
  if (has_read_rows)
    throw InputError("a choice that is recommended draws another picture than its row says; " + whose_fault(true));
  throw std::logic_error("a choice that is recommended draws another picture than was judged");
}

std::string picture_name(const AdviseOptions& options, const std::string& what) {
  std::string name = study::plot_stem(options.model.model) + "-" + what + ".png";
  for (char& c : name) c = c == ' ' ? '-' : c;
  return name;
}

study::Advice advice_of(const AdviseOptions& options, const Command& command, const AdviceQuestion& question,
                        const Rows& rows, bool has_read_rows) {
  study::Advice advice{study::recommend(rows, question.wishes), {}};
  for (const study::Recommendation& one : advice.recommendations) {
    check_by_drawing(question.job, one.row, has_read_rows);
    advice.commands.push_back(
        render_command(options, command, one.row, picture_name(options, study::recommendation_name(one.wish))));
  }
  const AdviceRow nearest = study::nearest_choices(rows, question.wishes, 1).front();
  if (study::meets_all(nearest, question.wishes)) return advice;
  check_by_drawing(question.job, nearest, has_read_rows);
  advice.nearest = nearest;
  advice.nearest_command = render_command(options, command, nearest, picture_name(options, "nearest"));
  return advice;
}

/// A picture of each choice that is recommended, which may be the best by several wishes.
std::vector<report::Picture> pictures_of(const AdviseOptions& options, const study::Advice& advice) {
  std::vector<std::pair<AdviceRow, std::string>> choices;
  const auto add = [&](const AdviceRow& row, const std::string& name) {
    const auto known = std::ranges::find(choices, row, &std::pair<AdviceRow, std::string>::first);
    if (known == choices.end()) {
      choices.emplace_back(row, name);
    } else {
      known->second += ", " + name;
    }
  };
  for (const study::Recommendation& one : advice.recommendations) add(one.row, study::recommendation_name(one.wish));
  if (advice.nearest) add(*advice.nearest, "nearest to all wishes");
  std::vector<report::Picture> pictures;
  pictures.reserve(choices.size());
  for (const auto& [row, name] : choices) pictures.push_back(picture_of(options, row, name));
  return pictures;
}

void refuse_failures(const Rows& rows, const study::Advice& advice, const study::Wishes& wishes, bool has_read_rows) {
  if (std::any_of(rows.begin(), rows.end(), [](const AdviceRow& row) { return row.unexplained > 0; }))
    throw InputError("a picture is wrong beyond the bounds of docs/numbers.md; " + whose_fault(has_read_rows));
  if (advice.nearest)
    throw InputError("no choice meets all wishes; the nearest has " + misses_text(*advice.nearest, wishes));
}

void run(const AdviseOptions& options, const Command& command) {
  const AdviceQuestion question = question_of(options);
  ReportFile report(options.report, options.model.inputs());
  std::optional<StudyFolder> folder;
  std::optional<Table> table;
  const std::string title = title_of(options, command);
  if (!options.folder.empty()) {
    folder.emplace(options.folder, "advise", options.model.inputs());
    const std::filesystem::path path = folder->path() / "advise.csv";
    table.emplace(path, title);
    const study::WantedAdvice any{question.points.front(), question.job.inputs};
    tell_stale(path, table->drop_stale(std::span(&any, 1)));
  }
  const bool has_read_rows = table && !table->rows().empty();
  const Rows rows = complete(options, question, table ? &*table : nullptr);
  if (std::none_of(rows.begin(), rows.end(), [](const AdviceRow& row) { return row.compiled(); }))
    throw InputError(rows.front().reason);
  const study::Advice advice = advice_of(options, command, question, rows, has_read_rows);
  const view::Sampling& sampling = question.job.sampling;
  print_question(fmt::format("{}, {} x {} pixels, on {}", options.model.model, sampling.width, sampling.height,
                             options.model.machine),
                 rows, question.wishes);
  print_front(rows, question.wishes);
  print_advice(advice, question.wishes);
  const std::string json = folder || report.asked() ? study::advice_json(title, question.wishes, rows, advice) : "";
  if (report.asked())
    report.write(report::advise_page(
        report::Json::parse(json),
        study::plot_of_advice(rows, question.wishes, advice.recommendations, study::plot_stem(options.model.model)),
        pictures_of(options, advice),
        plain_study_context(options.report, options.model.model, {{machine_of(options.model)}})));
  if (folder) {
    write_file(folder->path() / "advise.json", json);
    if (!options.no_plots)
      study::draw_advice_plot(rows, question.wishes, advice.recommendations, study::plot_stem(options.model.model),
                              folder->path());
    fmt::print("\n{}: advise.csv, advise.json{}\n", printable(options.folder),
               options.no_plots ? "" : ", and a plot (.png, .svg) of what memory buys");
  }
  refuse_failures(rows, advice, question.wishes, has_read_rows);
}

}  // namespace

void add_advise(CommandLine& line) {
  const auto options = std::make_shared<AdviseOptions>();
  Command command = line.add(
      "advise", "Find the cheapest memory for a model: what meets wishes for bits, wrong pixels, speed and colours",
      "Example:\n  csgsim advise carburettor.csg --camera 220,-255,135,2,0,5 --max-bits 64 --max-wrong-pixels 10 "
      "--min-fps 20\n"
      "  csgsim advise carburettor.csg --alu-bits 1,2,4,8 --min-colour-bits 12 -o carburettor-advice\n"
      "Lists are with commas, ranges of numbers as 3..8; every combination is measured. What has been measured is kept "
      "in\n"
      "advise.csv at once; the same command goes on after an interruption, and with other wishes measures nothing "
      "anew.");
  options->add_to(command);
  command.prints_summary();
  command.runs([options, command] { run(*options, command); });
}

}  // namespace csgsim::app
