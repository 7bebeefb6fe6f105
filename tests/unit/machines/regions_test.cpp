#include "hw/machines/regions.h"

#include <rapidcheck.h>

#include "hw/pixel_planes/kind.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "tests/support/coverage.h"
#include "tests/support/test.h"

using namespace csgsim;
using pixel_square::SquareOrder;

namespace {

machines::Machine squares_of(std::uint32_t width, std::uint32_t height, machines::Size picture, SquareOrder order) {
  machines::Machine machine = machines::blank_machine(pixel_square::kind);
  machine.array = {width, height, 8};
  machine.picture = picture;
  machines::kind_figures<pixel_square::Figures>(machine).order = order;
  return machine;
}

machines::Machine lines_of(machines::Size picture, bool interlaced) {
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.array = {picture.width, 1, 8};
  machine.picture = picture;
  machines::kind_figures<scan_line::Figures>(machine).interlaced = interlaced;
  return machine;
}

machines::Machine whole_of(machines::Size picture) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = {picture.width, picture.height, 8};
  machine.picture = picture;
  return machine;
}

}  // namespace

TEST_CASE("a two-level divider gets its squares group by group") {
  machines::Machine machine = squares_of(10, 10, {30, 25}, SquareOrder::serpentine);
  auto& figures = machines::kind_figures<pixel_square::Figures>(machine);
  figures.divider = pixel_square::DividerKind::corners;
  figures.group_side = 2;
  const std::vector<isa::Region> rows = {{0, 0, 10, 10},   {10, 0, 10, 10},  {20, 0, 10, 10},
                                         {20, 10, 10, 10}, {10, 10, 10, 10}, {0, 10, 10, 10},
                                         {0, 20, 10, 5},   {10, 20, 10, 5},  {20, 20, 10, 5}};
  CHECK(machines::regions(machine) == rows);
  figures.levels = 2;
  const std::vector<isa::Region> groups = {{0, 0, 10, 10},  {10, 0, 10, 10}, {10, 10, 10, 10},
                                           {0, 10, 10, 10}, {20, 0, 10, 10}, {20, 10, 10, 10},
                                           {20, 20, 10, 5}, {0, 20, 10, 5},  {10, 20, 10, 5}};
  CHECK(machines::regions(machine) == groups);
}

TEST_CASE("the regions of every machine cover each pixel of the picture once") {
  CHECK(rc::check([] {
    const auto side = [] { return *rc::gen::inRange<std::uint32_t>(1, 40); };
    const machines::Size picture{side(), side()};
    const auto order = static_cast<SquareOrder>(*rc::gen::inRange(0, 3));
    const machines::Machine machine = *rc::gen::element(
        squares_of(side(), side(), picture, order), lines_of(picture, *rc::gen::arbitrary<bool>()), whole_of(picture));
    testing::assert_covered_once(machines::regions(machine), picture);
  }));
}

TEST_CASE("interlaced lines begin with those of the even field") {
  std::vector<std::uint32_t> rows;
  for (const isa::Region& region : machines::regions(lines_of({8, 5}, true))) rows.push_back(region.y);
  CHECK(rows == std::vector<std::uint32_t>{0, 2, 4, 1, 3});
}

TEST_CASE("each square in serpentine order is adjacent to the previous one") {
  const std::vector<isa::Region> all = machines::regions(squares_of(4, 4, {19, 13}, SquareOrder::serpentine));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto apart = [](std::uint32_t a, std::uint32_t b) {
      return std::abs(static_cast<int>(a) - static_cast<int>(b));
    };
    CHECK(apart(all[i].x, all[i - 1].x) + apart(all[i].y, all[i - 1].y) == 4);
  }
}

TEST_CASE("squares in Morton order finish each quarter of the picture before the next") {
  std::vector<isa::Region> places;
  for (const isa::Region& region : machines::regions(squares_of(2, 2, {8, 8}, SquareOrder::morton))) {
    places.push_back({region.x / 4, region.y / 4, 0, 0});
  }
  const std::vector<isa::Region> quarters{{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}};
  for (std::size_t i = 0; i < places.size(); ++i) CHECK(places[i] == quarters[i / 4]);
}
