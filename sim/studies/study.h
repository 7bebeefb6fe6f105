// Interface of a study.
// Implemented by each study and used by the runner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/plots/plot.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/command_group.h"
#include "sim/session/options/option_list.h"
#include "sim/studies/parallel.h"
#include "sim/studies/row_text.h"
#include "sim/studies/rows_json.h"
#include "sim/studies/table.h"

namespace csgsim::report {
using Json = nlohmann::ordered_json;
struct Section;
}  // namespace csgsim::report

namespace csgsim::studies {

/// The subject of a page: its models and machines, and the picture that it shows.
struct PageSubject {
  session::ModelRequest model;
  std::vector<machines::Machine> machines;  ///< the picture is drawn on the first
  bool has_picture = true;
  std::string name{};  ///< name of the subject; the model's name if empty
};

/// A model on each machine of a comma-separated list.
PageSubject page_subject_on_machines(const session::ModelRequest& model, const std::string& machines);

/// The first of these models on the machines; named by the number of models if there are several.
PageSubject page_subject_of_models(const std::vector<std::string>& models, const session::ModelRequest& view,
                                   const std::string& machines);

/// A study defines the points that its options select, measures a point, and shows the rows. The runner (runner.h) does
/// the rest: common options, tables and resuming, progress, threads, shards, files and the page.
class Study {
 public:
  Study() = default;
  virtual ~Study() = default;
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  virtual void add_options(session::OptionList& command) = 0;
  /// The input files, which must not be overwritten; the first model is the first of them.
  [[nodiscard]] virtual std::vector<std::filesystem::path> inputs() const = 0;
  /// Options whose values are part of the points, so that one table can hold points for several values.
  [[nodiscard]] virtual std::set<std::string> varied_options() const { return {}; }
  /// The model if a table holds points of one model only: its file name is part of the table's title.
  [[nodiscard]] virtual std::string table_model() const { return {}; }
  /// Whether all points of the table belong to table_model() on one machine: if the model or the machine changes, all
  /// rows are outdated.
  [[nodiscard]] virtual bool is_of_one_machine() const { return false; }
  /// The model, or folder of models, that the output folder is named after if -o is not given: the first input.
  [[nodiscard]] virtual std::filesystem::path output_named_after() const { return inputs().front(); }

  /// Reads the inputs and returns the requested points. Called once, before anything is measured; not called by gather.
  virtual std::vector<PointRequest> request_points() = 0;
  /// Receives the number of a point and its row.
  using Finished = std::function<void(std::size_t point, std::string row)>;
  /// Measures the points with these numbers on `threads` threads; rows are passed on one at a time, in any order.
  virtual void measure(std::span<const std::size_t> points, unsigned threads, const Finished& finished) = 0;
  /// Whether a row of the point, read from the table, has all requested results. Its inputs are unchanged.
  [[nodiscard]] virtual bool has_requested_results(std::size_t /*point*/, const std::string& /*row*/) const {
    return true;
  }

  [[nodiscard]] virtual RowFormat format() const = 0;

  /// Receives the rows of the requested points in their order; the functions below show these. `are_read`: some rows
  /// were not measured by this process.
  virtual void set_rows(std::span<const std::string> rows, bool are_read) = 0;
  /// Further points to measure, given all rows received until now; their numbers follow those of the earlier points.
  virtual std::vector<PointRequest> request_more_points() { return {}; }
  /// Whether request_more_points() may return points, so that the study cannot be sharded.
  [[nodiscard]] virtual bool is_adaptive() const { return false; }
  virtual void print() const = 0;
  [[nodiscard]] virtual std::string json(const std::string& title) const = 0;
  [[nodiscard]] virtual std::vector<plots::Plot> plots() const { return {}; }
  /// The page's title before the model's name.
  [[nodiscard]] virtual std::string page_title() const = 0;
  [[nodiscard]] virtual PageSubject page_subject() const = 0;
  /// The part of json() that a page keeps; `points`, if present, become its last table.
  [[nodiscard]] virtual report::Json page_data(report::Json file) const;
  /// Sections of a page before plots and points.
  [[nodiscard]] virtual std::vector<report::Section> sections(const report::Json& data) const;
  /// Throws InputError if the rows show an error; called after everything has been written.
  virtual void refuse() const {}
};

/// Where results are written if -o is not given.
enum class Folder : std::uint8_t {
  usual,     ///< in default_output_folder() (folder.h)
  optional,  ///< nowhere
};

/// A row of the table of all studies.
struct StudyRow {
  const char* name;
  const char* does;         ///< one-line summary that begins with a verb
  const char* example;      ///< example and notes below the help text
  const char* plots;        ///< description, such as `plots (.png, .svg) of clocks`
  bool is_parallel = true;  ///< points may be measured in parallel
  bool has_shards = true;
  bool is_quick = false;  ///< a point takes less time than writing a row, so rows are written in groups
  std::unique_ptr<Study> (*make)() = nullptr;
  std::string_view group = session::study_group;  ///< heading in `csgsim --help`
};

/// Stores the rows of a study, all of type `Row`. Of the columns that Row::columns() visits, the first
/// `Row::point_columns` identify the point, and the next three are the hashes and the version in Row::inputs. A row
/// with a non-empty `Row::reason`, if there is such a member, states why the point could not be measured.
template <class Row>
class RowsOf : public Study {
 public:
  [[nodiscard]] RowFormat format() const final { return row_format<Row>(); }

  void set_rows(std::span<const std::string> rows, bool are_read) final {
    rows_.clear();
    rows_.reserve(rows.size());
    for (const std::string& row : rows) rows_.push_back(from_line<Row>(row));
    are_read_ = are_read;
    derive_results();
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    return rows_json(title, std::span<const Row>(rows_));
  }

 protected:
  /// Derives results from the rows before they are shown.
  virtual void derive_results() {}

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] bool are_read() const { return are_read_; }

 private:
  std::vector<Row> rows_;
  bool are_read_ = false;
};

/// A study whose points are measured independently.
template <class Row>
class StudyOf : public RowsOf<Row> {
 public:
  void measure(std::span<const std::size_t> points, unsigned threads, const Study::Finished& finished) final {
    const std::vector<std::size_t> order = measuring_order(points, threads);
    measure_each(
        order.size(), threads, [&](std::size_t i) { return std::pair(order[i], to_line(measure_point(order[i]))); },
        [&](std::pair<std::size_t, std::string> row) { finished(row.first, std::move(row.second)); });
  }

 protected:
  /// Measures the point with this number; called by several threads concurrently if the study is parallel.
  [[nodiscard]] virtual Row measure_point(std::size_t point) = 0;

  /// The points in the order in which `threads` threads measure them.
  [[nodiscard]] virtual std::vector<std::size_t> measuring_order(std::span<const std::size_t> points,
                                                                 unsigned /*threads*/) const {
    return {points.begin(), points.end()};
  }
};

}  // namespace csgsim::studies
