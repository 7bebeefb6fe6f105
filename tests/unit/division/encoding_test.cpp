#include "hw/division/encoding.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;

namespace {

division::Bits first_bits(const division::Bits& bits, std::uint64_t count) {
  division::BitReader in(bits);
  division::BitWriter out;
  for (std::uint64_t i = 0; i < count; ++i) out.put(in.take(1), 1);
  return out.take();
}

void check_refused(const std::function<void(division::DisplayModel&)>& change) {
  division::DisplayModel model = testing::slab_with_hole();
  change(model);
  CHECK_THROWS_AS(division::encode(model), InputError);
}

}  // namespace

TEST_CASE("the display model is sent least significant bit first across words") {
  division::BitWriter out;
  out.put(5, 3);
  out.put(0x123456789abcdef0, 64);
  out.put_signed(-3, 4);
  out.put(0, 0);
  const division::Bits bits = out.take();
  CHECK(bits.count == 71);
  CHECK(bits.words ==
        std::vector<std::uint64_t>{0x123456789abcdef0U << 3U | 5U, 0x123456789abcdef0U >> 61U | 13U << 3U});
  division::BitReader in(bits);
  CHECK(in.take(3) == 5);
  CHECK(in.take(64) == 0x123456789abcdef0);
  CHECK(in.take_signed(4) == -3);
  CHECK(in.left() == 0);
  CHECK_THROWS_AS(in.take(1), InputError);
}

TEST_CASE("a display model takes the minimum number of link words") {
  CHECK(division::link_words(0, 32) == 0);
  CHECK(division::link_words(64, 32) == 2);
  CHECK(division::link_words(65, 32) == 3);
}

TEST_CASE("the display model of a slab takes the documented number of bits") {
  const division::DisplayModel model = testing::one_slab();
  // Counts 3 x 32, sides 2 x 15, numbers of bits 5 x 5, widths 3 x 6, fields 7 x 13 and 1, background 3.
  CHECK(division::widths_of(model).header() == 264);
  // Planes of 1 + 1 + 1 + 5 bits; a primitive of 4 x 15 + 2 x 5 + 2 + 2 and its colour; half-spaces of 1 + 1, one with
  // a colour; a leaf.
  CHECK(division::encode(model).count == 264 + 2 * 8 + 74 + 3 + 2 * 2 + 3 + 1);
}

TEST_CASE("decode() of a display model inverts encode()") {
  for (const division::DisplayModel& model : {testing::empty_model(), testing::one_slab(), testing::slab_with_hole()})
    CHECK(division::decode(division::encode(model)) == model);
}

TEST_CASE("a display model is decoded from link words of any width") {
  const division::DisplayModel model = testing::slab_with_hole();
  const division::Bits bits = division::encode(model);
  for (const unsigned width : {1U, 7U, 16U, 32U, 64U, 100U, 256U}) {
    CAPTURE(width);
    std::vector<isa::LinkWord> words = division::to_link(bits, width);
    CHECK(words.size() == division::link_words(bits.count, width));
    CHECK(words[0].number(0, 1) == bits.words[0] % 2);
    CHECK(division::from_link(words, width) == model);
    words.emplace_back();
    CHECK_THROWS_AS(static_cast<void>(division::from_link(words, width)), InputError);
    words.resize(words.size() - 2);
    CHECK_THROWS_AS(static_cast<void>(division::from_link(words, width)), InputError);
  }
  for (const unsigned wrong : {31U, 32U}) {
    std::vector<isa::LinkWord> words = division::to_link(bits, 32);
    words.back().put(wrong, 1, 1);
    CHECK_THROWS_AS(static_cast<void>(division::from_link(words, 32)), InputError);
  }
}

TEST_CASE("a display model that is truncated or extended is rejected") {
  const division::Bits whole = division::encode(testing::slab_with_hole());
  for (std::uint64_t count = 0; count < whole.count; ++count)
    CHECK_THROWS_AS(division::decode(first_bits(whole, count)), InputError);
  division::Bits more = whole;
  ++more.count;
  if (more.count % 64 == 1) more.words.push_back(0);
  CHECK_THROWS_AS(division::decode(more), InputError);
  division::Bits torn = whole;
  torn.words.pop_back();
  CHECK_THROWS_AS(division::decode(torn), InputError);
}

TEST_CASE("a corrupted display model is rejected or valid") {
  const division::Bits sent = division::encode(testing::slab_with_hole());
  CHECK(rc::check([&] {
    division::Bits bits = sent;
    for (int flips = *rc::gen::inRange(1, 4); flips > 0; --flips) {
      const auto bit = *rc::gen::inRange<std::uint64_t>(0, bits.count);
      bits.words[bit / 64] ^= std::uint64_t{1} << bit % 64;
    }
    try {
      const division::DisplayModel model = division::decode(bits);
      division::validate(model);
      RC_ASSERT(division::encode(model) == bits);
    } catch (const InputError&) {
      RC_SUCCEED("refused");
    }
  }));
}

TEST_CASE("an invalid display model is rejected before it is sent") {
  using division::DisplayModel;
  check_refused([](DisplayModel& model) { model.width = 0; });
  check_refused([](DisplayModel& model) { model.height = 16'385; });
  check_refused([](DisplayModel& model) { model.z_bits = 3; });
  check_refused([](DisplayModel& model) { model.fraction_bits = 21; });
  check_refused([](DisplayModel& model) { model.colour_bits = 25; });
  check_refused([](DisplayModel& model) { model.background = 8; });
  check_refused([](DisplayModel& model) { model.fields.mask.base = 10; });
  check_refused([](DisplayModel& model) { model.fields.mask.width = 2; });
  check_refused([](DisplayModel& model) { model.fields.stack_base = 11; });
  check_refused([](DisplayModel& model) { model.fields.stack_bits = 4096; });
  check_refused([](DisplayModel& model) { model.planes[0].c = std::int64_t{1} << 61U; });
  check_refused([](DisplayModel& model) { model.planes[0].a = std::int64_t{1} << 57U; });
  check_refused([](DisplayModel& model) { model.primitives[0].box.pixels.x1 = 16; });
  check_refused([](DisplayModel& model) { model.primitives[0].box.pixels = {3, 0, 2, 0}; });
  check_refused([](DisplayModel& model) { model.primitives[0].box.z_low = 17; });
  check_refused([](DisplayModel& model) { model.primitives[0].box.z_high = 16; });
  check_refused([](DisplayModel& model) { model.primitives[0].joined = true; });
  check_refused([](DisplayModel& model) { model.primitives[1].joined = true; });
  check_refused([](DisplayModel& model) { model.primitives[1].near_colour = 1; });
  check_refused([](DisplayModel& model) { model.primitives[0].near_colour = 8; });
  check_refused([](DisplayModel& model) { model.primitives[0].halfspaces[0].plane = 4; });
  check_refused([](DisplayModel& model) { model.primitives[0].halfspaces[0].colour = 8; });
  check_refused([](DisplayModel& model) { model.primitives[0].halfspaces[1].colour = 1; });
  check_refused([](DisplayModel& model) { model.nodes.pop_back(); });
  check_refused([](DisplayModel& model) { model.nodes.back().operands = 3; });
  check_refused([](DisplayModel& model) { model.nodes.back().operands = 1; });
  check_refused([](DisplayModel& model) { model.primitives.pop_back(); });
}
