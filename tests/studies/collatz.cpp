#include "tests/studies/collatz.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/read_by.h"

namespace csgsim::testing {

namespace {

struct CollatzRow {
  static constexpr std::size_t point_columns = 2;

  std::string number;
  unsigned addend = 1;
  studies::Inputs inputs;
  std::uint64_t steps = 0;
  std::uint64_t highest = 0;
  std::string reason;

  static void columns(auto& row, const auto& visit) {
    visit("number", row.number);
    visit("addend", row.addend);
    studies::Inputs::columns(row.inputs, visit);
    visit("clocks", row.steps);  // its title on a page comes from the vocabulary
    visit("highest", row.highest);
    visit("reason", row.reason);
  }
};

std::vector<unsigned> addends_of(const std::string& text) { return session::parse_numbers(text, 1, 99); }

class Collatz : public studies::StudyOf<CollatzRow> {
 public:
  void add_options(session::OptionList& command) override {
    command.option("FILE", file_, "Numbers, a line each").required();
    command.option("--addends", addends_, "Numbers: what is added to three times an odd number")
        .check(session::check_by_parsing(addends_of));
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return {file_}; }
  [[nodiscard]] std::set<std::string> varied_options() const override { return {"addends"}; }

  std::vector<studies::PointRequest> request_points() override {
    const std::string text = read_file(file_, {"a file of numbers", 1000, "make it shorter"});
    Hash hash;
    hash.add(text);
    std::vector<studies::PointRequest> requested;
    std::istringstream lines(text);
    for (std::string number; std::getline(lines, number);) {
      for (const unsigned addend : addends_of(addends_)) {
        points_.push_back({number, addend, {hash.text(), "none", "1"}, 0, 0, {}});
        requested.push_back({fmt::format("{},{}", number, addend), points_.back().inputs});
      }
    }
    return requested;
  }

  void print() const override {
    for (const CollatzRow& row : rows()) fmt::print("{} {}: {}\n", row.number, row.addend, row.steps);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    plots::Chart chart{"Steps to 1", {"number"}, {{"steps"}}, {{"steps"}}, "collatz.csv"};
    for (const CollatzRow& row : rows()) {
      if (row.reason.empty())
        chart.series.front().points.push_back({std::stod(row.number), static_cast<double>(row.steps)});
    }
    return {{"collatz_steps", std::move(chart)}};
  }

  [[nodiscard]] std::string page_title() const override { return "Steps to 1"; }
  [[nodiscard]] studies::PageSubject page_subject() const override { return {{}, {}, false, file_}; }

  void refuse() const override {
    if (std::ranges::none_of(rows(), [](const CollatzRow& row) { return row.reason.empty(); }))
      throw InputError(file_ + ": no line of it is a number");
  }

 protected:
  [[nodiscard]] CollatzRow measure_point(std::size_t point) override {
    CollatzRow row = points_[point];
    std::uint64_t number = std::strtoull(row.number.c_str(), nullptr, 10);
    if (number == 0) row.reason = "that is no number from 1 on";
    while (number > 1 && row.steps < 1000) {
      row.highest = std::max(row.highest, number);
      number = number % 2 == 0 ? number / 2 : 3 * number + row.addend;
      ++row.steps;
    }
    return row;
  }

 private:
  std::string file_;
  std::string addends_ = "1";
  std::vector<CollatzRow> points_;
};

}  // namespace

const studies::StudyRow collatz_row{
    .name = "collatz",
    .does = "Count the steps to 1",
    .example = "  csgsim collatz numbers.txt --addends 1,3 -o out",
    .plots = "a plot (.png, .svg) of steps",
    .make = [] { return std::unique_ptr<studies::Study>(std::make_unique<Collatz>()); }};

}  // namespace csgsim::testing
