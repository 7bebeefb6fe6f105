
#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/read/read.h"
#include "hw/kinds/load.h"
#include "sim/report/parts_html.h"
#include "sim/studies/corpus/measure.h"
#include "tests/unit/studies/study_rows.h"

using namespace csgsim;

TEST_CASE("corpus gives a reason and a size for a machine that cannot draw the model") {
  model::Tree tree = read::read_csg_text("cube(size=14,center=true);", "test");
  facet::Geometry scene = facet::make_geometry(tree);
  const auto subject = std::make_shared<studies::Subject>(studies::Subject{std::move(tree), std::move(scene), "hash"});
  machines::Machine machine = kinds::load("pixel-planes-4");
  machine.array = {40, 40, 30};
  view::Sampling sampling;
  sampling.width = sampling.height = 40;
  const studies::Job job{subject, {{40, -60, 45}, {0, 0, 0}}, sampling, machine, {}, {}};
  const studies::CorpusRow row = studies::measure({"a.csg", "m"}, job);
  CHECK(row.reason.find("memory bits") != std::string::npos);
  CHECK(row.width == 40);
  for (std::uint64_t studies::CorpusRow::*const count :
       {&studies::CorpusRow::primitives, &studies::CorpusRow::pieces, &studies::CorpusRow::halfspaces,
        &studies::CorpusRow::clocks, &studies::CorpusRow::interval_clocks, &studies::CorpusRow::setup,
        &studies::CorpusRow::render, &studies::CorpusRow::classify, &studies::CorpusRow::stack,
        &studies::CorpusRow::merge, &studies::CorpusRow::shade, &studies::CorpusRow::effect,
        &studies::CorpusRow::latency, &studies::CorpusRow::instructions, &studies::CorpusRow::pixel_operations,
        &studies::CorpusRow::enabled})
    CHECK(row.*count == 0);
  CHECK(row.used_bits == 0);
}

TEST_CASE("the page of corpus has a table of distributions per machine") {
  const report::Json data = report::Json::parse(
      R"({"distributions": {"m": {"clocks": {"count": 3, "minimum": 5, "median": 7, "maximum": 1234, "total": 1246},
                                  "used_bits": {"count": 3, "minimum": 66, "median": 66, "maximum": 70}},
                            "n": {"clocks": {"count": 1, "median": 9}}}})");
  const std::vector<report::Section> sections = studies::corpus_row.make()->sections(data);
  REQUIRE(sections.size() == 1);
  REQUIRE(sections.front().parts.size() == 2);
  const auto& table = std::get<report::Table>(sections.front().parts.front());
  REQUIRE(table.rows.size() == 2);
  const std::string html = report::table_html(table);
  for (const char* const part : {"<th scope=row>clocks</th>", "data-at=\"/distributions/m/clocks/maximum\">1,234<",
                                 "<th scope=row>used bits</th>", "data-at=\"/distributions/m/used_bits/maximum\">70<"})
    CHECK(html.find(part) != std::string::npos);
  CHECK(html.find("/distributions/n/") == std::string::npos);
}
