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

/// Whose figures a page tells, and of what it shows a picture.
struct PageSubject {
  session::ModelRequest model;
  std::vector<machines::Machine> machines;  ///< the picture is drawn on the first
  bool has_picture = true;
  std::string name{};  ///< of what was studied; the model's if empty
};

/// A model on each of these machines, which a list names.
PageSubject subject_on(const session::ModelRequest& model, const std::string& machines);

/// The first of these models on the machines, or the number of models if there are several.
PageSubject subject_of(const std::vector<std::string>& models, const session::ModelRequest& view,
                       const std::string& machines);

/// What a study is: which points its options ask for, what is measured at a point, and what is shown of the rows. All
/// else is the runner's (runner.h): options of all studies, the table and what is done again, progress, threads,
/// shards, files and the page.
class Study {
 public:
  Study() = default;
  virtual ~Study() = default;
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  virtual void add_options(session::OptionList& command) = 0;
  /// The files that are read, which nothing may be written over.
  [[nodiscard]] virtual std::vector<std::filesystem::path> inputs() const = 0;
  /// Options whose values are in the points, so that one table holds points of several.
  [[nodiscard]] virtual std::set<std::string> varied() const { return {}; }
  /// The model, where one table holds points of one model only: its file's name is part of the table's title.
  [[nodiscard]] virtual std::string table_model() const { return {}; }
  /// Whether all of a table is of that model on one machine, which its points depend on too.
  [[nodiscard]] virtual bool is_of_one_machine() const { return false; }
  /// Where the results are put if nobody says.
  [[nodiscard]] virtual std::string usual_folder() const { return {}; }

  /// Reads what is asked for. Called once, before anything is measured; not at all where all has been.
  virtual std::vector<Asked> ask() = 0;
  /// Gets the number of a point and its row.
  using Finished = std::function<void(std::size_t point, std::string row)>;
  /// Measures the points with these numbers on that many threads; rows are finished one at a time, in any order.
  virtual void measure(std::span<const std::size_t> points, unsigned threads, const Finished& finished) = 0;
  /// Whether a row of the point, measured from the same inputs, tells all that is asked for now.
  [[nodiscard]] virtual bool serves(std::size_t /*point*/, const std::string& /*row*/) const { return true; }

  [[nodiscard]] virtual RowFormat format() const = 0;

  /// The rows of the points asked for, in their order; what follows is about them. `are_read` says that some were not
  /// measured by this process.
  virtual void take(std::span<const std::string> rows, bool are_read) = 0;
  /// Points to be measured besides, now that all rows so far have been taken; their numbers go on from those before.
  virtual std::vector<Asked> more() { return {}; }
  /// Whether more() may ask for any, so that points cannot be shared out beforehand.
  [[nodiscard]] virtual bool looks_further() const { return false; }
  virtual void print() const = 0;
  [[nodiscard]] virtual std::string json(const std::string& title) const = 0;
  [[nodiscard]] virtual std::vector<plots::Plot> plots() const { return {}; }
  /// A page's title before the model's name.
  [[nodiscard]] virtual std::string page_title() const = 0;
  [[nodiscard]] virtual PageSubject page_subject() const = 0;
  /// What a page keeps of json(): `points`, if they are in it, are its last table.
  [[nodiscard]] virtual report::Json page_data(report::Json file) const;
  /// What a page tells before plots and points.
  [[nodiscard]] virtual std::vector<report::Section> sections(const report::Json& data) const;
  /// Throws InputError for rows that show a fault, when all has been written.
  virtual void refuse() const {}
};

/// How a study gets its folder.
enum class Folder : std::uint8_t {
  named,     ///< by -o, which has to be given
  usual,     ///< Study::usual_folder(), if -o is not given
  optional,  ///< without -o nothing is kept
};

/// A row of the table of studies.
struct StudyRow {
  const char* name;
  const char* does;     ///< in a line
  const char* example;  ///< and what else is to be said below the help
  const char* plots;    ///< as in `plots (.png, .svg) of clocks`
  Folder folder = Folder::named;
  bool is_parallel = true;  ///< points may be measured at the same time
  bool has_shards = true;
  bool is_quick = false;  ///< several points are measured while one row goes to the disk
  std::unique_ptr<Study> (*make)() = nullptr;
  std::string_view group = session::study_group;  ///< heading in `csgsim --help`
};

/// Has the rows of a study, which are of one type: `Row::point_columns` columns, of which Row::columns(row, visit)
/// tells, say which point it is, the next three its `inputs`; a `reason`, if it has one, is why the point could not be
/// measured.
template <class Row>
class RowsOf : public Study {
 public:
  [[nodiscard]] RowFormat format() const final { return format_of<Row>(); }

  void take(std::span<const std::string> rows, bool are_read) final {
    rows_.clear();
    rows_.reserve(rows.size());
    for (const std::string& row : rows) rows_.push_back(from_line<Row>(row));
    are_read_ = are_read;
    conclude();
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    return rows_json(title, std::span<const Row>(rows_));
  }

 protected:
  /// What has to be found out of the rows before they are shown.
  virtual void conclude() {}

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] bool are_read() const { return are_read_; }

 private:
  std::vector<Row> rows_;
  bool are_read_ = false;
};

/// A study whose points are measured by themselves.
template <class Row>
class StudyOf : public RowsOf<Row> {
 public:
  void measure(std::span<const std::size_t> points, unsigned threads, const Study::Finished& finished) final {
    const std::vector<std::size_t> order = in_turn(points, threads);
    measure_each(
        order.size(), threads, [&](std::size_t i) { return std::pair(order[i], to_line(measured(order[i]))); },
        [&](std::pair<std::size_t, std::string> row) { finished(row.first, std::move(row.second)); });
  }

 protected:
  /// Measures the point with that number; on several threads at the same time, where the study is parallel.
  [[nodiscard]] virtual Row measured(std::size_t point) = 0;

  /// The points in the order in which `threads` threads measure them.
  [[nodiscard]] virtual std::vector<std::size_t> in_turn(std::span<const std::size_t> points,
                                                         unsigned /*threads*/) const {
    return {points.begin(), points.end()};
  }
};

}  // namespace csgsim::studies
