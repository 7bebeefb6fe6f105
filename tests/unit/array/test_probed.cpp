#include <rapidcheck.h>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_replay.h"
#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/probed_trees.h"
#include "tests/support/quadratic_trees.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using array::Place;

std::vector<Place> any_places(array::PlaneShape shape) {
  std::vector<Place> places(*rc::gen::inRange<std::size_t>(1, 5));
  for (Place& place : places) place = {*rc::gen::inRange(0U, shape.width), *rc::gen::inRange(0U, shape.height)};
  return places;
}

/// Root bits of each clock: streams of any width, some back to back, some with idle clocks between them.
class AnyStream {
 public:
  explicit AnyStream(bool has_squares) : has_squares_(has_squares) {}

  array::RootBits next() {
    if (left_ == 0 && *rc::gen::weightedElement<bool>({{4, true}, {1, false}})) {
      left_ = *rc::gen::inRange(1, 30);
      squares_ = has_squares_ && *rc::gen::arbitrary<bool>();
      bit_ = 0;
    }
    if (left_ == 0) return {};
    --left_;
    array::RootBits bits{
        {bit_++}, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    if (!squares_) return bits;
    bits.xx = *rc::gen::arbitrary<bool>();
    bits.xy = *rc::gen::arbitrary<bool>();
    bits.yy = *rc::gen::arbitrary<bool>();
    return bits;
  }

 private:
  bool has_squares_;
  int left_ = 0;
  bool squares_ = false;  ///< whether the stream has squares
  std::int16_t bit_ = 0;
};

bool same(const array::LevelProbe& one, const array::LevelProbe& other) {
  if (one.token != other.token) return false;
  return !one.token.active() || (one.stream == other.stream && one.carry == other.carry);
}

bool same_slopes(const array::LevelProbe& one, const array::LevelProbe& other) {
  return !one.token.active() ||
         (one.slope == other.slope && one.slope_carry == other.slope_carry && one.step_carry == other.step_carry &&
          one.row_slope == other.row_slope && one.row_slope_carry == other.row_slope_carry);
}

}  // namespace

TEST_CASE("LinearEvaluator matches adder-by-adder trees at every level and clock") {
  CHECK(rc::check([] {
    const array::PlaneShape shape{*rc::gen::inRange(1U, 140U), *rc::gen::inRange(1U, 40U)};
    const std::vector<Place> places = any_places(shape);
    array::LinearEvaluator whole(shape);
    test::ProbedTrees probed(shape, places);
    RC_ASSERT(probed.x_levels() == whole.x_levels());
    RC_ASSERT(probed.y_levels() == whole.y_levels());
    array::StreamBit whole_leaves;
    array::Words probed_leaves(array::PlaneShape{static_cast<std::uint32_t>(places.size()), 1}.padded_words());
    AnyStream stream(false);
    for (int clock = 0; clock < 120; ++clock) {
      const array::RootBits root = stream.next();
      for (std::uint32_t i = 0; i < places.size(); ++i) {
        for (unsigned k = 0; k <= whole.x_levels(); ++k)
          RC_ASSERT(same(whole.x_level(k, places[i].x, root), probed.x_level(k, i, root)));
        for (unsigned k = 0; k <= whole.y_levels(); ++k)
          RC_ASSERT(same(whole.y_level(k, places[i], root), probed.y_level(k, i, root)));
      }
      const bool reached = whole.clock(root, whole_leaves);
      RC_ASSERT(probed.clock(root, probed_leaves) == reached);
      RC_ASSERT(probed.any_active() == whole.any_active());
      for (std::uint32_t i = 0; i < places.size(); ++i) {
        RC_ASSERT(whole_leaves.at(places[i]) == ((probed_leaves[0] >> i & 1U) != 0));
      }
    }
  }));
}

TEST_CASE("LinearEvaluator matches adder-by-adder trees of degree 2") {
  CHECK(rc::check([] {
    const array::PlaneShape shape{*rc::gen::inRange(1U, 140U), *rc::gen::inRange(1U, 40U)};
    const Place place = any_places(shape).front();
    array::LinearEvaluator whole(shape);
    test::QuadraticWay way(shape, place);
    array::StreamBit leaves;
    AnyStream stream(true);
    for (int clock = 0; clock < 120; ++clock) {
      const array::RootBits root = stream.next();
      const auto check = [](const array::LevelProbe& found, const array::LevelProbe& expected) {
        RC_ASSERT(same(found, expected));
        RC_ASSERT(same_slopes(found, expected));
      };
      for (unsigned k = 0; k <= whole.x_levels(); ++k) check(whole.x_level(k, place.x, root), way.x_level(k, root));
      for (unsigned k = 0; k <= whole.y_levels(); ++k) check(whole.y_level(k, place, root), way.y_level(k, root));
      if (whole.clock(root, leaves) && whole.latency() > 0)
        RC_ASSERT(leaves.at(place) == whole.y_level(whole.y_levels(), place, {}).stream);
      way.clock(root);
    }
  }));
}

TEST_CASE("PixelReplay matches the reference with and without skipping disabled pixels") {
  CHECK(rc::check([] {
    constexpr std::uint32_t bits = 40;
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 12U), *rc::gen::inRange(1U, 12U), bits};
    const std::vector<Place> places = any_places({shape.width, shape.height});
    const auto reads = *rc::gen::inRange(1U, 3U);
    const auto alu = *rc::gen::inRange(1U, 9U);
    const auto trees = *rc::gen::inRange(1U, alu + 1);
    const isa::Region region{0, 0, *rc::gen::inRange(1U, shape.width + 1), *rc::gen::inRange(1U, shape.height + 1)};
    array::PixelReplay replay(places, bits, array::Sequencer(reads, alu, trees), alu);
    array::PixelReplay quick = replay;
    replay.begin(region);
    quick.begin(region);
    reference::ReferenceArray reference(region, bits);
    bool passes_over = true;
    for (int n = 0; n < 40; ++n) {
      isa::Instruction one = *test::arbitrary_instruction({region.width, region.height, bits}, bits, 3);
      if (*rc::gen::inRange(0, 6) == 0) one = {.opcode = isa::Opcode::enable_all};
      reference.execute(one);
      replay.execute(one);
      passes_over = passes_over && n < 25;
      passes_over ? quick.execute_where_enabled(one) : quick.execute(one);
      for (std::uint32_t i = 0; i < places.size(); ++i) {
        const Place at = places[i];
        if (at.x >= region.width || at.y >= region.height) continue;
        const auto same_as_reference = [&](const array::PixelReplay& pixels) {
          const bool enabled = pixels.pixels().probe(i, 0, pixels.tree()).enable;
          if (enabled != reference.is_enabled(at.x, at.y)) return false;
          for (std::uint16_t bit = 0; bit < bits; ++bit) {
            if (pixels.pixels().memory_bit(bit, i, 0) != (reference.read({bit, 1}, at.x, at.y) != 0)) return false;
          }
          return true;
        };
        RC_ASSERT(same_as_reference(replay));
        RC_ASSERT(same_as_reference(quick));
      }
    }
    if (!quick.registers_known()) return;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      const array::PixelProbe expected = replay.pixels().probe(i, 0, replay.tree());
      const array::PixelProbe found = quick.pixels().probe(i, 0, quick.tree());
      RC_ASSERT(found.tree == expected.tree);
      RC_ASSERT(found.carry == expected.carry);
      RC_ASSERT(found.latch == expected.latch);
    }
  }));
}
