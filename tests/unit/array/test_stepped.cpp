#include <rapidcheck.h>

#include <deque>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/array/stepped_evaluator.h"
#include "hw/isa/instruction.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using array::LevelProbe;
using array::Place;
using array::PlaneShape;
using array::RootBits;

constexpr std::uint16_t widest = isa::max_linear_width;

/// Random streams of the given widths, back to back or with idle clocks between them.
class Streams {
 public:
  Streams(const std::vector<std::uint16_t>& widths, array::TreeForm form, std::uint64_t seed)
      : widths_(widths.begin(), widths.end()), form_(form), random_(seed) {}

  [[nodiscard]] bool over() const { return left_ == 0 && widths_.empty(); }

  RootBits next() {
    if (left_ == 0 && widths_.empty()) return {};
    if (left_ == 0) {
      if (random_() % 3 == 0) return {};
      left_ = widths_.front();
      widths_.pop_front();
      bit_ = 0;
      squares_ = form_.degree > 1 && random_() % 3 > 0;
    }
    const auto bits = static_cast<std::uint16_t>(std::min(left_, form_.bits));
    const array::Token token{bit_, bits};
    left_ -= bits;
    bit_ = static_cast<std::int16_t>(bit_ + bits);
    const auto any = [&] { return static_cast<std::uint32_t>(random_() & array::low_bits(bits)); };
    const auto any_square = [&] { return squares_ ? any() : 0; };
    return {token, any(), any(), any(), any_square(), any_square(), any_square()};
  }

 private:
  std::deque<std::uint16_t> widths_;
  array::TreeForm form_;
  std::mt19937_64 random_;
  unsigned left_ = 0;
  bool squares_ = false;
  std::int16_t bit_ = 0;
};

bool same(const LevelProbe& stepped, const LevelProbe& computed, unsigned degree) {
  if (stepped.token != computed.token) return false;
  if (!stepped.token.active()) return true;
  if (stepped.stream != computed.stream || stepped.carry != computed.carry) return false;
  return degree < 2 || (stepped.slope == computed.slope && stepped.slope_carry == computed.slope_carry &&
                        stepped.step_carry == computed.step_carry && stepped.row_slope == computed.row_slope &&
                        stepped.row_slope_carry == computed.row_slope_carry);
}

/// The token's bits at a pixel, taken from consecutive planes.
std::uint32_t leaves_at(const array::Words& planes, PlaneShape shape, Place place, array::Token token) {
  std::uint32_t bits = 0;
  for (std::size_t bit = 0; bit < token.bits; ++bit) {
    const std::span<const std::uint64_t> plane(&planes[bit * shape.padded_words()], shape.padded_words());
    bits |= static_cast<std::uint32_t>(array::bit_of(plane, shape, place.x, place.y)) << bit;
  }
  return bits;
}

/// Whether both agree at all clocks until the last bit has reached the pixels. `pixels` lists those that are built;
/// empty means all.
bool agree(PlaneShape shape, array::TreeForm form, const std::vector<Place>& pixels, const std::vector<Place>& probed,
           Streams streams) {
  array::LinearEvaluator computed(shape, form.register_levels);
  array::SteppedEvaluator stepped(shape, form, pixels);
  array::Words bits(stepped.leaf_words());
  array::StreamBit expected;
  const PlaneShape built = pixels.empty() ? shape : PlaneShape{static_cast<std::uint32_t>(pixels.size()), 1};
  bool agrees = true;
  while (agrees && (!streams.over() || computed.any_active())) {
    const RootBits root = streams.next();
    for (const Place place : probed) {
      for (unsigned k = 0; k <= computed.x_levels(); ++k)
        agrees &= same(stepped.x_level(k, place.x, root), computed.x_level(k, place.x, root), form.degree);
      for (unsigned k = 0; k <= computed.y_levels(); ++k)
        agrees &= same(stepped.y_level(k, place, root), computed.y_level(k, place, root), form.degree);
    }
    const bool reached = computed.clock(root, expected);
    const array::Token token = stepped.clock(root, bits);
    agrees &= token.active() == reached && stepped.any_active() == computed.any_active();
    if (!reached) continue;
    agrees &= token == expected.token;
    for (std::uint32_t y = 0; y < built.height; ++y) {
      for (std::uint32_t x = 0; x < built.width; ++x)
        agrees &= leaves_at(bits, built, {x, y}, token) == expected.at(pixels.empty() ? Place{x, y} : pixels[x]);
    }
  }
  return agrees;
}

/// Stores the bits of a pixel in consecutive planes.
void put_leaves(std::uint32_t leaves, PlaneShape shape, Place place, array::Words& planes) {
  for (std::size_t first = shape.word_of(place.x, place.y); first < planes.size(); first += shape.padded_words()) {
    planes[first] |= std::uint64_t{leaves & 1U} << (place.x % array::word_bits);
    leaves >>= 1U;
  }
}

std::vector<Place> any_places(PlaneShape shape, std::size_t most) {
  std::vector<Place> places(*rc::gen::inRange<std::size_t>(1, most + 1));
  for (Place& place : places) place = {*rc::gen::inRange(0U, shape.width), *rc::gen::inRange(0U, shape.height)};
  return places;
}

std::vector<std::uint16_t> any_widths(std::size_t count) {
  std::vector<std::uint16_t> widths(count);
  for (std::uint16_t& width : widths) width = *rc::gen::inRange<std::uint16_t>(1, widest + 1);
  return widths;
}

/// Any number of bits per clock and of levels between registers, often one.
array::TreeForm any_form(unsigned degree) {
  return {degree, *rc::gen::weightedOneOf<unsigned>({{1, rc::gen::just(1U)}, {3, rc::gen::inRange(2U, 33U)}}),
          *rc::gen::weightedOneOf<unsigned>({{2, rc::gen::just(1U)}, {3, rc::gen::inRange(2U, 17U)}})};
}

PlaneShape any_shape() { return {*rc::gen::inRange(1U, 140U), *rc::gen::inRange(1U, 40U)}; }

}  // namespace

TEST_CASE("stepped trees match the evaluator at every level and clock") {
  for (const unsigned degree : {1U, 2U}) {
    CAPTURE(degree);
    CHECK(rc::check([degree] {
      const PlaneShape shape = any_shape();
      const array::TreeForm form = any_form(degree);
      RC_ASSERT(agree(shape, form, {}, any_places(shape, 3),
                      Streams(any_widths(3), form, *rc::gen::arbitrary<std::uint64_t>())));
    }));
  }
}

TEST_CASE("stepped trees of selected pixels match those of the whole array") {
  for (const unsigned degree : {1U, 2U}) {
    CAPTURE(degree);
    CHECK(rc::check([degree] {
      const PlaneShape shape = any_shape();
      const std::vector<Place> pixels = any_places(shape, 70);
      const array::TreeForm form = any_form(degree);
      RC_ASSERT(agree(shape, form, pixels, {pixels.front(), pixels.back()},
                      Streams(any_widths(3), form, *rc::gen::arbitrary<std::uint64_t>())));
    }));
  }
}

TEST_CASE("stepped trees pass streams of any width for any depth and bits per clock") {
  std::vector<std::uint16_t> every(widest);
  std::iota(every.begin(), every.end(), std::uint16_t{1});
  for (const unsigned degree : {1U, 2U}) {
    for (const PlaneShape shape : {PlaneShape{1, 1}, PlaneShape{1, 2}, PlaneShape{2, 1}, PlaneShape{5, 3},
                                   PlaneShape{1, 33}, PlaneShape{64, 1}, PlaneShape{65, 9}}) {
      CAPTURE(degree);
      CAPTURE(shape.width);
      CAPTURE(shape.height);
      const Place last{shape.width - 1, shape.height - 1};
      // Each number of bits, or only powers of two.
      for (unsigned bits = 1; bits <= 32; bits += testing::draws_usual_cases() ? 1 : bits) {
        CAPTURE(bits);
        for (const unsigned register_levels : {1U, 2U, 5U}) {
          CAPTURE(register_levels);
          const array::TreeForm form{degree, bits, register_levels};
          CHECK(agree(shape, form, {}, {last}, Streams(every, form, bits)));
        }
      }
    }
  }
}

TEST_CASE("pixels given the bits of F match pixels given its coefficients") {
  CHECK(rc::check([] {
    constexpr std::uint32_t memory_bits = 40;
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 140U), *rc::gen::inRange(1U, 30U), memory_bits};
    const auto alu_bits = *rc::gen::inRange(1U, 6U);
    const auto tree_bits = *rc::gen::inRange(1U, alu_bits + 1);
    const PlaneShape plane{shape.width, shape.height};
    array::PixelArray by_coefficients(shape, alu_bits);
    array::PixelArray by_bits(shape, alu_bits);
    array::Sequencer sequencer(*rc::gen::inRange(1U, 3U), alu_bits, tree_bits);
    array::Words bits(tree_bits * plane.padded_words());
    array::StreamBit tree;
    for (int n = 0; n < 15; ++n) {
      const isa::Instruction one = *test::arbitrary_instruction(shape, memory_bits, 0);
      sequencer.begin(one);
      while (sequencer.busy()) {
        const array::BitStep step = sequencer.issue();
        if (step.root.token.active()) {
          tree = {.token = step.root.token,
                  .a = static_cast<std::uint64_t>(one.linear.a),
                  .b = static_cast<std::uint64_t>(one.linear.b),
                  .c = static_cast<std::uint64_t>(one.linear.c)};
          std::fill(bits.begin(), bits.end(), 0);
          for (std::uint32_t y = 0; y < shape.height; ++y) {
            for (std::uint32_t x = 0; x < shape.width; ++x) put_leaves(tree.at({x, y}), plane, {x, y}, bits);
          }
        }
        by_coefficients.step(step.pixels, tree);
        by_bits.step_with_planes(bits, step.pixels);
      }
      if (*rc::gen::inRange(0, 2) > 0) continue;
      for (std::uint32_t y = 0; y < shape.height; ++y) {
        for (std::uint32_t x = 0; x < shape.width; ++x) {
          const array::PixelProbe expected = by_coefficients.probe(x, y, tree);
          const array::PixelProbe found = by_bits.probe(x, y, tree);
          RC_ASSERT(found.carry == expected.carry);
          RC_ASSERT(found.enable == expected.enable);
          RC_ASSERT(found.flag == expected.flag);
          RC_ASSERT(found.latch == expected.latch);
        }
      }
      for (std::uint32_t bit = 0; bit < memory_bits; ++bit)
        RC_ASSERT(by_bits.memory(bit) == by_coefficients.memory(bit));
    }
  }));
}

TEST_CASE("stepped trees match the evaluator at the depth of the largest arrays") {
  for (const unsigned degree : {1U, 2U}) {
    CHECK(rc::check([degree] {
      const PlaneShape shape{*rc::gen::inRange(1000U, isa::max_array_side + 1),
                             *rc::gen::inRange(1000U, isa::max_array_side + 1)};
      const std::vector<Place> pixels = any_places(shape, 2);
      const array::TreeForm form = any_form(degree);
      RC_ASSERT(agree(shape, form, pixels, pixels, Streams({widest}, form, *rc::gen::arbitrary<std::uint64_t>())));
    }));
  }
}
