// Tests of the study of csgsim explore --sensitivity: the figures and points that it requests, and refused options.

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "hw/kinds/load.h"
#include "sim/session/options/usage.h"
#include "sim/studies/sensitivity/figures.h"
#include "sim/studies/sensitivity/show.h"
#include "tests/unit/studies/explored.h"

using namespace csgsim;
using namespace csgsim::studies;
using testing::Explored;
using testing::Models;
using testing::Texts;

TEST_CASE("ranges exclude sizes, varied figures, and figures with one value") {
  std::vector<RangedFigure> figures;
  add_ranged_figures(kinds::load("pixel-planes-4").figures, false, {"link.latency"}, figures);
  std::set<std::string> keys;
  for (const RangedFigure& figure : figures) keys.insert(figure.key);
  CHECK(keys.contains("link.width"));
  CHECK_FALSE(keys.contains("link.latency"));
  CHECK_FALSE(keys.contains("memory.writes"));
  CHECK_FALSE(keys.contains("alu.bits"));
  for (const char* const size : {"picture.width", "array.height", "array.memory_bits"}) CHECK(is_size_figure(size));
}

TEST_CASE("changes are printed in per cent with sign") {
  CHECK(change_text(1.34) == "+34 %");
  CHECK(change_text(0.968) == "-3.2 %");
  CHECK(change_text(0.9004) == "-10 %");
  CHECK(change_text(1.0004) == "0 %");
}

TEST_CASE("explore --sensitivity requests all variants of each design once") {
  const Models models;
  const Texts words{models / "cube.csg", "--size",   "8x8",       "--vary", "alu.bits=1,2",
                    "--process",         "nmos-3um", "--samples", "2",      "--sensitivity"};
  Explored explored(words);
  const Texts cells = explored.ask();
  const auto has = [&](const std::string& design, const std::string& process) {
    return std::ranges::any_of(cells, [&](const std::string& cell) {
      return cell.find("," + design + "," + process + ",") != std::string::npos;
    });
  };
  CHECK(has("pixel-planes-4+alu.bits=1", "nmos-3um"));
  CHECK(has("pixel-planes-4+alu.bits=2", "nmos-3um+gate.delay=2000"));
  CHECK(has("pixel-planes-4+alu.bits=2+link.width=16", "nmos-3um"));
  CHECK_FALSE(has("pixel-planes-4+alu.bits=2+alu.bits=1", "nmos-3um"));
  CHECK(std::set<std::string>(cells.begin(), cells.end()).size() == cells.size());
  CHECK(cells.size() % 2 == 0);

  const std::vector<PointRequest>& asked = explored.asked;
  std::set<std::string> machines;
  for (const PointRequest& one : asked) machines.insert(one.inputs.machine_hash);
  CHECK(machines.size() == asked.size());
}

TEST_CASE("explore refuses --sensitivity with a search and --samples alone") {
  const Models models;
  const auto error = [&](const Texts& more) -> std::string {
    Texts words{models / "cube.csg", "--size", "8x8"};
    words.insert(words.end(), more.begin(), more.end());
    try {
      Explored(words).ask();
    } catch (const session::UsageError& refused) {
      return refused.what();
    }
    return "";
  };
  CHECK(error({"--vary", "z-bits=12", "--search", "3", "--sensitivity"}).find("remove --search") != std::string::npos);
  CHECK(error({"--vary", "z-bits=12", "--samples", "3"}).find("only --sensitivity") != std::string::npos);
  CHECK(error({"--vary", "z-bits=8..30", "--samples", "1000", "--sensitivity"}).find("the maximum is 10,000") !=
        std::string::npos);
}
