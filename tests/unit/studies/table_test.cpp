#include "sim/studies/table.h"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "places.h"
#include "sim/studies/processors.h"
#include "tests/support/error_of.h"

using namespace csgsim;

namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<std::size_t>;
using Rows = std::vector<std::string>;

/// A row of a test study: its point and a number.
struct TestRow {
  static constexpr std::size_t point_columns = 2;

  std::string name;
  std::string value;
  studies::Inputs inputs{"model", "machine", "0.1.0"};
  double number = 0;

  static void columns(auto& row, const auto& visit) {
    visit("name", row.name);
    visit("value", row.value);
    studies::Inputs::columns(row.inputs, visit);
    visit("number", row.number);
  }
};

const std::string plain_header = "name,value,model_hash,machine_hash,csgsim,number\n";

std::string row(const std::string& value, double number, const studies::Inputs& inputs = TestRow().inputs) {
  return studies::to_line(TestRow{"a, b", value, inputs, number});
}

studies::PointRequest requested(const std::string& value, const studies::Inputs& inputs = TestRow().inputs) {
  return {"\"a, b\"," + value, inputs};
}

studies::Table table_at(const fs::path& path, const std::string& title = "a study",
                        studies::HasRequestedResults serves = studies::accept_any_row) {
  return {path, title, studies::row_format<TestRow>(), std::move(serves)};
}

fs::path fresh(const std::string& name) {
  fs::path path = fs::path(CSGSIM_BINARY_DIR) / name;
  fs::remove(path);
  return path;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("a table resumes after an interruption and drops a partial last line") {
  const fs::path path = fresh("table_interrupted.csv");
  table_at(path).add(Rows{row("10/2", 0.1234567890123456789), row("12/2", 2)});
  std::ofstream(path, std::ios::app) << "\"a, b\",14/2,99";
  studies::Table table = table_at(path);
  REQUIRE(table.rows() == Rows{row("10/2", 0.1234567890123456789), row("12/2", 2)});
  const std::array points{requested("12/2"), requested("14/2")};
  CHECK(table.missing(points) == Numbers{1});
  table.add(Rows{row("14/2", 3)});
  CHECK(table.missing(points).empty());
  CHECK(table_at(path).rows().size() == 3);
}

TEST_CASE("a table of another study is rejected and kept") {
  const fs::path path = fresh("table_other.csv");
  table_at(path, "one study").add(Rows{row("10/2", 1)});
  const std::string before = content(path);
  CHECK_THROWS_AS(table_at(path, "another study"), InputError);
  CHECK(content(path) == before);
}

TEST_CASE("the error for a broken table line names its file and line and column") {
  for (const std::size_t before : {0U, 1U, 2U}) {
    CAPTURE(before);
    const fs::path path = fresh("table_broken.csv");
    table_at(path).add(Rows(before, row("10/2", 1)));
    std::ofstream(path, std::ios::app) << "a,12/2,model,machine,0.1.0,many\n";
    // The invalid line follows the header and `before` valid lines.
    const std::string place = "table_broken.csv:" + std::to_string(2 + before) + ":1: 'many'";
    CHECK(testing::error_of([&] { table_at(path); }).find(place) != std::string::npos);
  }
}

TEST_CASE("a table cut off within its first lines is replaced by an empty one") {
  for (const char* const left : {"# a st", "name,val", ""}) {
    const fs::path path = fresh("table_cut.csv");
    std::ofstream(path) << left;
    CHECK(table_at(path).rows().empty());
    CHECK(table_at(path).rows().empty());
    CHECK(content(path) == plain_header);
  }
}

TEST_CASE("a table is plain CSV and a file beside it names its study") {
  const fs::path path = fresh("table_plain.csv");
  table_at(path, "one study").add(Rows{row("10/2", 1)});
  CHECK(content(path) == plain_header + row("10/2", 1) + "\n");
  CHECK(content(fs::path(path).replace_extension(".study")) == "one study\n");
  fs::remove(fs::path(path).replace_extension(".study"));
  CHECK_THROWS_AS(table_at(path, "one study"), InputError);  // the study of its rows is unknown
  // A table without rows may be used by any study.
  std::ofstream(path) << plain_header;
  CHECK(table_at(path, "another study").rows().empty());
  CHECK(content(fs::path(path).replace_extension(".study")) == "another study\n");
}

TEST_CASE("a table with its title in a comment is converted and keeps its rows") {
  const fs::path path = fresh("table_commented.csv");
  fs::remove(fs::path(path).replace_extension(".study"));
  const std::string commented = "# a study\n" + plain_header + row("10/2", 1) + "\n" + row("12/2", 2) + "\n";
  std::ofstream(path) << commented << "\"a, b\",14/2,99";
  CHECK_THROWS_AS(table_at(path, "another study"), InputError);
  CHECK(content(path).starts_with(commented));
  CHECK(table_at(path).rows() == Rows{row("10/2", 1), row("12/2", 2)});
  CHECK(content(path) == plain_header + row("10/2", 1) + "\n" + row("12/2", 2) + "\n");
  CHECK(table_at(path).rows().size() == 2);
}

TEST_CASE("a point is missing unless a row with equal inputs serves the request") {
  const fs::path path = fresh("table_wanted.csv");
  studies::Table table =
      table_at(path, "a study", [](std::size_t, const std::string& one) { return one.ends_with(",2"); });
  table.add(Rows{row("x", 1)});
  const std::array point{requested("x")};
  CHECK(table.missing(point) == Numbers{0});
  table.add(Rows{row("x", 2)});
  CHECK(table.missing(point).empty());
  CHECK(table.ordered_rows(point) == Rows{row("x", 2)});
  CHECK(table.rows() == Rows{row("x", 2)});  // the row that does not serve the request is deleted
  for (std::string studies::Inputs::*const input :
       {&studies::Inputs::model_hash, &studies::Inputs::machine_hash, &studies::Inputs::csgsim}) {
    studies::Inputs others = TestRow().inputs;
    others.*input = "another";
    CHECK(table.missing(std::array{requested("x", others)}) == Numbers{0});
  }
}

TEST_CASE("rows of requested points with outdated inputs are deleted from a table") {
  const fs::path path = fresh("table_stale.csv");
  studies::Table table = table_at(path);
  table.add(Rows{row("x", 1), row("y", 2), row("z", 3)});
  CHECK(table.drop_stale(std::array{requested("x")}, false).empty());
  CHECK(table.rows().size() == 3);
  studies::Inputs now = TestRow().inputs;
  now.machine_hash = "of an edited file";
  CHECK(table.drop_stale(std::array{requested("x", now), requested("z", now)}, false) ==
        std::set<std::string>{"the machine"});
  CHECK(table_at(path).rows() == Rows{row("y", 2)});
  // A table for one model on one machine keeps no rows of others.
  now.model_hash = "of another file";
  CHECK(table.drop_stale(std::array{requested("x", now)}, true) == std::set<std::string>{"the machine", "the model"});
  CHECK(table_at(path).rows().empty());
}

TEST_CASE("rows of a table follow the order of requested points before other rows") {
  const fs::path path = fresh("table_order.csv");
  studies::Table table = table_at(path);
  table.add(Rows{row("other", 0), row("y", 2), row("x", 1)});
  const std::array points{requested("x"), requested("y")};
  CHECK(table.ordered_rows(points) == Rows{row("x", 1), row("y", 2)});
  CHECK(table_at(path).rows() == Rows{row("x", 1), row("y", 2), row("other", 0)});
}

TEST_CASE("a table without a file keeps rows in memory") {
  studies::Table table(studies::row_format<TestRow>());
  const std::array points{requested("x"), requested("y")};
  table.add(Rows{row("y", 2)});
  CHECK(table.missing(points) == Numbers{0});
  table.add(Rows{row("x", 1)});
  CHECK(table.ordered_rows(points) == Rows{row("x", 1), row("y", 2)});
}

TEST_CASE("seconds in a table have four digits and no exponents for large values") {
  CHECK(studies::seconds_text(0.0217777) == "0.02178");
  CHECK(studies::seconds_text(56.0) == "56");
  CHECK(studies::seconds_text(999.94) == "999.9");
  CHECK(studies::seconds_text(1234.4) == "1,234");
  CHECK(studies::seconds_text(12044.5) == "12,045");
}