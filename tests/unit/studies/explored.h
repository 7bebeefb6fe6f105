#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/studies/design/row.h"
#include "sim/studies/row_text.h"
#include "sim/studies/runner.h"
#include "tests/unit/studies/study_rows.h"

/// The study of csgsim explore, for tests.
namespace csgsim::testing {

using Texts = std::vector<std::string>;

/// A folder with small models that the destructor deletes.
struct Models {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("csgsim-explore-study-" + std::to_string(::getpid()));

  Models() {
    std::filesystem::create_directory(folder);
    write("cube.csg", "cube(size = [8, 6, 4]);\n");
    write("two.csg", "union() { cube(size = [8, 6, 4]); cube(size = [2, 2, 9]); }\n");
    write("wrong.csg", "cube(size = ;\n");
  }
  ~Models() { std::filesystem::remove_all(folder); }
  Models(const Models&) = delete;
  Models& operator=(const Models&) = delete;

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return folder / name; }
};

/// The study requested by the words of a command line.
struct Explored {
  session::OptionList list{"explore"};
  std::shared_ptr<studies::StudyCommand> command = studies::add_library_study_options(list, studies::explore_row);
  std::vector<studies::PointRequest> asked{};

  explicit Explored(const Texts& words) {
    list.give_words(words);
    list.check_and_apply();
  }

  [[nodiscard]] studies::Study& study() const { return *command->study; }

  Texts ask() {
    asked = study().request_points();
    return cells();
  }
  [[nodiscard]] Texts cells() const {
    Texts all;
    for (const studies::PointRequest& one : asked) all.push_back(one.cells);
    return all;
  }

  /// Measures every requested point.
  Texts measure() {
    std::vector<std::size_t> points(asked.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    Texts rows(asked.size());
    study().measure(points, 1, [&](std::size_t point, std::string row) { rows[point] = std::move(row); });
    study().set_rows(rows, false);
    return rows;
  }
};

inline studies::ExploreRow row_in(const std::string& line) { return studies::from_line<studies::ExploreRow>(line); }

}  // namespace csgsim::testing
