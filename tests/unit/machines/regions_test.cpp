#include "hw/machines/regions.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <vector>

using namespace csgsim;
using machines::Kind;
using machines::SquareOrder;

namespace {

machines::Machine squares_of(std::uint32_t width, std::uint32_t height, machines::Size picture, SquareOrder order) {
  machines::Machine machine;
  machine.kind = Kind::pixel_square;
  machine.array = {width, height, 8};
  machine.picture = picture;
  machine.pixel_square.order = order;
  return machine;
}

}  // namespace

TEST_CASE("the regions of any machine cover every pixel of its picture once") {
  CHECK(rc::check([] {
    const auto side = [] { return *rc::gen::inRange<std::uint32_t>(1, 40); };
    const machines::Size picture{side(), side()};
    const auto order = static_cast<SquareOrder>(*rc::gen::inRange(0, 3));
    machines::Machine machine = squares_of(side(), side(), picture, order);
    machine.kind = static_cast<Kind>(*rc::gen::inRange(0, 3));
    machine.scan_line.interlaced = *rc::gen::arbitrary<bool>();
    if (machine.kind == Kind::frame_buffer) machine.array = {picture.width, picture.height, 8};
    std::vector<int> covered(std::size_t{picture.width} * picture.height);
    for (const isa::Region& region : machines::regions(machine)) {
      RC_ASSERT(region.width > 0U && region.height > 0U);
      for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
        for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
          RC_ASSERT(x < picture.width && y < picture.height);
          ++covered[std::size_t{y} * picture.width + x];
        }
      }
    }
    RC_ASSERT(covered == std::vector<int>(covered.size(), 1));
  }));
}

TEST_CASE("interlaced lines come even ones first") {
  machines::Machine machine = squares_of(8, 1, {8, 5}, SquareOrder::rows);
  machine.kind = Kind::scan_line;
  machine.scan_line.interlaced = true;
  std::vector<std::uint32_t> rows;
  for (const isa::Region& region : machines::regions(machine)) rows.push_back(region.y);
  CHECK(rows == std::vector<std::uint32_t>{0, 2, 4, 1, 3});
}

TEST_CASE("serpentine order goes from each square to one beside it") {
  const std::vector<isa::Region> all = machines::regions(squares_of(4, 4, {19, 13}, SquareOrder::serpentine));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto apart = [](std::uint32_t a, std::uint32_t b) {
      return std::abs(static_cast<int>(a) - static_cast<int>(b));
    };
    CHECK(apart(all[i].x, all[i - 1].x) + apart(all[i].y, all[i - 1].y) == 4);
  }
}

TEST_CASE("Morton order finishes a quarter of the picture before it goes on to the next") {
  std::vector<isa::Region> places;
  for (const isa::Region& region : machines::regions(squares_of(2, 2, {8, 8}, SquareOrder::morton))) {
    places.push_back({region.x / 4, region.y / 4, 0, 0});
  }
  const std::vector<isa::Region> quarters{{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}};
  for (std::size_t i = 0; i < places.size(); ++i) CHECK(places[i] == quarters[i / 4]);
}
