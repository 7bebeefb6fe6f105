#include <sys/resource.h>

#include <chrono>

#include "hw/base/address_sanitizer.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"
#include "tests/unit/read/tree_invariants.h"

using namespace csgsim::model;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

std::string repeat(std::string_view part, std::size_t times) {
  std::string text;
  text.reserve(part.size() * times);
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

std::string megabytes(std::string_view part) { return repeat(part, (std::size_t{100} << 20U) / part.size()); }

/// Peak memory of this process in MB.
std::size_t peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) >> 10U;
}

}  // namespace

TEST_CASE("a model 20000 levels deep is read") {
  const std::size_t depth = 20'000;
  const Tree chain = read(repeat("difference(){", depth) + "cube(1);" + repeat("sphere(r=1);}", depth));
  CHECK(count(chain).differences == depth);
  CHECK(broken_invariant(chain) == "");
  const Tree comb = read(repeat("union(){cube(1);", depth) + repeat("}", depth));
  CHECK(count(comb).unions == depth - 1);
  CHECK(broken_invariant(comb) == "");
  CHECK(read(repeat("group(){", depth) + "cube(1);" + repeat("}", depth)).nodes.size() == 1);
}

TEST_CASE("a model with 20000 children of a node is read") {
  const std::size_t width = 20'000;
  const Tree tree = read("difference(){" + repeat("cube(1);", width) + "}");
  CHECK(count(tree).differences == width - 1);
  CHECK(tree.nodes.back().children.size() == width);
  CHECK(broken_invariant(tree) == "");
}

TEST_CASE("a model with 100000 open braces is accepted and one more rejected") {
  const std::size_t limit = 100'000;
  CHECK(read(repeat("group(){", limit) + "cube(1);" + repeat("}", limit)).nodes.size() == 1);
  CHECK(error_of(repeat("group(){", limit + 1)) ==
        fmt::format("m.csg:1:{}: braces are nested more than 100000 deep; split the model", 8 * limit + 8));
  CHECK(error_of(repeat("%group(){", limit + 1)) ==
        fmt::format("m.csg:1:{}: braces are nested more than 100000 deep; split the model", 9 * limit + 9));
}

constexpr bool sanitized = CSGSIM_ADDRESS_SANITIZER == 1;  // under this sanitizer it takes minutes

TEST_CASE("100 MB of repeated text are rejected in one line quickly and in little memory" * doctest::skip(sanitized)) {
  struct Case {
    std::string_view before;
    std::string_view part;
    std::string_view message;
  };
  const Case cases[] = {
      {"", "{", "m.csg:1:1: expected a node such as cube(...), or `}`, found `{`"},
      {"", "[", "m.csg:1:1: expected a node such as cube(...), or `}`, found `[`"},
      {"", "(", "m.csg:1:1: expected a node such as cube(...), or `}`, found `(`"},
      {"", "}", "m.csg:1:1: unmatched `}`; remove it"},
      {"cube(", "(", "m.csg:1:6: expected `name = value`, a value or `)` in cube(...), found `(`"},
      {"cube(", "[", "m.csg:1:14: vectors are nested more than 8 deep; no node needs this"},
      {"cube(", "[],", "m.csg:1:12000006: more than 4000000 values in one node; split the node"},
      {"cube(", "1,", "m.csg:1:8000006: more than 4000000 values in one node; split the node"},
      {"cube(", "size=1,", "m.csg:1:28000011: more than 4000000 values in one node; split the node"},
      {"cube(", "1",
       "m.csg:1:6: number out of range: 1111111111111111111111111111111111111111... exceeds the range of doubles; "
       "correct it"},
      {"", "a",
       "m.csg:1:104857601: expected `(` after aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa..., found the end of the file"},
      {"", "group(){", "m.csg:1:800008: braces are nested more than 100000 deep; split the model"},
      {"", "group(){}", "m.csg:1:36000001: more than 4000000 nodes; split the model"},
      {"", "*group(){}", "m.csg:1:40000002: more than 4000000 nodes; split the model"},
      {"", "cube(1);", "m.csg:1:8000001: more than 1000000 solids; split the model"},
      {"", "intersection(){cube(0);}", "m.csg:1:48000001: more than 4000000 nodes; split the model"},
      {"", "%", "m.csg:1:104857601: expected a node such as cube(...) after its modifier, found the end of the file"},
      {"", ";", "m.csg: no model found; export one from OpenSCAD"},
      {"/*", "*", "m.csg:1:1: this comment never ends; close it with */"},
      {"", "//", "m.csg: no model found; export one from OpenSCAD"},
      {"color(\"", "\\\"", "m.csg:1:7: this string never ends; close it with \" before `)` or `, name =`"},
  };
  for (const Case& one : cases) {
    CAPTURE(one.before);
    CAPTURE(one.part);
    const auto start = std::chrono::steady_clock::now();
    CHECK(error_of(std::string(one.before) + megabytes(one.part)) == one.message);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    CHECK(seconds.count() < 20);
  }
  CHECK(peak_megabytes() < 500);
}
