#include "sim/suite/results.h"

#include "sim/suite/compare.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const std::string some_hash = "0123456789abcdef";
const std::string other_hash = "fedcba9876543210";

std::vector<suite::Row> read(const std::string& text) { return suite::read_results(text, "r.csv"); }

struct Wrong {
  std::string text;
  std::string error;
};

/// The expected values of two machines that run the same Program.
std::vector<suite::Row> expected() {
  return read(
      "case,machine,picture,program,clocks,enable_all\n"
      "one,pp,0123456789abcdef,00000000000000aa,100,3\n"
      "one,dram,0123456789abcdef,00000000000000aa,900,3\n"
      "one,lines,0123456789abcdef,00000000000000bb,50,7\n");
}

suite::Comparison compared(const std::string& row) {
  return suite::compare(expected(), read("case,machine,picture,program,clocks,enable_all\n" + row).front());
}

}  // namespace

TEST_CASE("results are read with columns in any order, comments, quotes and empty cells") {
  const std::vector<suite::Row> rows = read(
      "# host: a computer\r\n\nclocks,machine,case,picture,simulator\r\n0012,\"a,b\",one,,\"the "
      "\"\"x\"\"\"\r\n,m,one," +
      some_hash + ",");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].at("clocks") == "12");
  CHECK(rows[0].machine() == "a,b");
  CHECK(rows[0].name() == "one");
  CHECK(rows[0].at("picture").empty());
  CHECK(rows[0].at("simulator") == "the \"x\"");
  CHECK(rows[1].at("picture") == some_hash);
  CHECK(suite::find_row(rows, "one", "m") == &rows[1]);
  CHECK(suite::find_row(rows, "two", "m") == nullptr);
}

TEST_CASE("a written table has the filled columns and is read unchanged") {
  suite::Row row;
  row.at("case") = "one";
  row.at("machine") = "#\"odd\", name";
  row.at("keep_min") = "7";
  const std::string text = suite::results_text(std::span(&row, 1));
  CHECK(text == "case,machine,keep_min\none,\"#\"\"odd\"\", name\",7\n");
  CHECK(read(text) == std::vector<suite::Row>{row});
}

TEST_CASE("a wrong table of results is rejected with its place") {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"", "r.csv:1:1: the table has no line of column names"},
           {"# only a comment\n", "r.csv:1:1: the table has no line of column names"},
           {"case,machine,clock\n", "r.csv:1:14: there is no column 'clock'; did you mean clocks?"},
           {"case,clocks\n", "r.csv:1:1: the column 'machine' is missing"},
           {"case,machine,case\n", "r.csv:1:14: the column 'case' occurs twice"},
           {"case,machine\n\none\n", "r.csv:3:1: the line has 1 cells and the table 2 columns"},
           {"case,machine\none,\n", "r.csv:2:5: 'machine' is empty"},
           {"case,machine,clocks\none,pp,1.5\n", "r.csv:2:8: clocks: '1.5' is not a whole number"},
           {"case,machine,clocks\none,pp,-1\n", "r.csv:2:8: clocks: '-1' is not a whole number"},
           {"case,machine,clocks\none,pp,18446744073709551616\n", "is not a whole number below 2^64"},
           {"case,machine,seconds\none,pp,inf\n", "r.csv:2:8: seconds: 'inf' is not a number of seconds"},
           {"case,machine,picture\none,pp,0123456789ABCDEF\n", "r.csv:2:8: picture: '0123456789ABCDEF' is not a hash"},
           {"case,machine\none,\"pp\n", "r.csv:2:5: the quote is not closed"},
           {"case,machine\none,pp\none,pp\n", "r.csv:3:1: there is a second line of one on pp"}}) {
    CAPTURE(wrong.text);
    const std::string error = testing::error_of([&] { read(wrong.text); });
    CAPTURE(error);
    CHECK(error.find(wrong.error) != std::string::npos);
  }
}

TEST_CASE("a row is compared with that of its case and machine, cell by cell") {
  const suite::Comparison same = compared("one,pp,0123456789abcdef,00000000000000aa,100,3\n");
  CHECK(same.values == 4);
  CHECK(same.differences.empty());
  const suite::Comparison partly = compared("one,pp,,,101,3\n");
  CHECK(partly.values == 2);
  CHECK(partly.differences == std::vector<suite::Difference>{{"one", "pp", "clocks", "100", "101"}});
}

TEST_CASE("a machine without expected values is compared with one of the same Program") {
  const suite::Comparison same_program = compared("one,new,fedcba9876543210,00000000000000bb,1,8\n");
  CHECK(same_program.values == 3);
  CHECK(same_program.differences == std::vector<suite::Difference>{{"one", "new", "picture", some_hash, other_hash},
                                                                   {"one", "new", "enable_all", "7", "8"}});
  const suite::Comparison other_program = compared("one,new,0123456789abcdef,00000000000000cc,1,8\n");
  CHECK(other_program.values == 1);
  CHECK(other_program.differences.empty());
  CHECK(compared("two,pp,0123456789abcdef,,,\n").values == 0);
}
