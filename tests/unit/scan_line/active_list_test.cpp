#include "hw/scan_line/active_list.h"

#include <rapidcheck.h>

#include "hw/isa/extents.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::RowExtent;
using scan_line::ActiveList;

namespace {

isa::Segment line_of(std::uint32_t row, const std::vector<isa::Origin>& origins) {
  isa::Segment line{.region = {0, row, 4, 1}, .instructions = {}};
  for (const isa::Origin& origin : origins)
    line.instructions.push_back({.opcode = isa::Opcode::enable_all, .origin = origin});
  return line;
}

}  // namespace

TEST_CASE("a primitive extends from the first to the last row in which it is used") {
  const std::vector<isa::Segment> lines{line_of(0, {}), line_of(1, {{.primitive = 7}, {}}),
                                        line_of(2, {{.primitive = 3, .node = 9}}),
                                        line_of(3, {{.primitive = 7, .node = 9}})};
  std::vector<RowExtent> extents = isa::compute_row_extents(lines);
  std::sort(extents.begin(), extents.end(), [](const RowExtent& one, const RowExtent& other) {
    return std::pair(one.first, one.last) < std::pair(other.first, other.last);
  });
  CHECK(extents == std::vector<RowExtent>{{1, 3}, {2, 2}, {2, 3}});
}

TEST_CASE("the host visits primitives that enter or stay in or leave the active list") {
  ActiveList list;
  list.begin(std::vector<RowExtent>{{1, 3}, {2, 2}, {2, 3}});
  std::vector<std::size_t> looks;
  for (std::uint32_t row = 0; row < 6; ++row) looks.push_back(list.advance_to(row));
  CHECK(looks == std::vector<std::size_t>{0, 1, 3, 3, 2, 0});
}

TEST_CASE("an interlaced field takes two buckets per row and starts with an empty list") {
  ActiveList list;
  list.begin(std::vector<RowExtent>{{1, 3}, {2, 2}, {2, 3}});
  std::vector<std::size_t> looks;
  for (const std::uint32_t row : {0U, 2U, 4U, 1U, 3U, 5U}) looks.push_back(list.advance_to(row));
  CHECK(looks == std::vector<std::size_t>{0, 3, 3, 1, 3, 2});
}

TEST_CASE("the host visits each primitive once on each of its rows and once below them") {
  CHECK(rc::check([] {
    constexpr std::uint32_t rows = 20;
    std::vector<RowExtent> primitives;
    std::size_t expected = 0;
    const auto count = *rc::gen::inRange(0, 30);
    for (int i = 0; i < count; ++i) {
      const auto first = *rc::gen::inRange(0U, rows);
      const auto last = *rc::gen::inRange(first, rows);
      primitives.push_back({static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)});
      expected += last - first + (last + 1 < rows ? 2U : 1U);
    }
    ActiveList list;
    list.begin(primitives);
    std::size_t looks = 0;
    for (std::uint32_t row = 0; row < rows; ++row) looks += list.advance_to(row);
    RC_ASSERT(looks == expected);
  }));
}
