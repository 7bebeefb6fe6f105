#include "hw/pixel_square/output_buffer.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;

namespace {

/// Pixels whose memory holds a number each, from bit `base` on; all other bits are 1.
class NumberedPixels final : public pixel_planes::RefreshPort {
 public:
  NumberedPixels(std::uint32_t width, std::uint32_t height, isa::Field field, std::vector<std::uint32_t> numbers)
      : width_(width), height_(height), field_(field), numbers_(std::move(numbers)), row_((width + 63) / 64) {}

  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const override {
    RC_ASSERT(row < height_);
    row_.assign(row_.size(), ~std::uint64_t{0});
    if (address < field_.base || address >= field_.end()) return row_;
    for (std::uint32_t x = 0; x < width_; ++x) {
      const bool bit = (numbers_[row * width_ + x] >> (address - field_.base) & 1U) != 0;
      if (!bit) row_[x / 64] &= ~(std::uint64_t{1} << x % 64);
    }
    return row_;
  }

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  isa::Field field_;
  std::vector<std::uint32_t> numbers_;
  mutable std::vector<std::uint64_t> row_;
};

std::vector<pixel_square::PortWord> sent(pixel_square::OutputBuffer& buffer) {
  std::vector<pixel_square::PortWord> words;
  for (; buffer.busy(); buffer.advance()) words.push_back(buffer.word());
  return words;
}

}  // namespace

TEST_CASE("the output buffer sends a square's header and then the colours of its pixels") {
  CHECK(rc::check([] {
    const std::uint32_t width = *rc::gen::inRange(1U, 140U);
    const std::uint32_t height = *rc::gen::inRange(1U, 5U);
    const std::uint32_t port_bits = *rc::gen::inRange(1U, 200U);
    const isa::Field colour{*rc::gen::inRange<std::uint16_t>(0, 9), *rc::gen::inRange<std::uint16_t>(0, 33)};
    const isa::Region region{*rc::gen::inRange(0U, 65536U), *rc::gen::inRange(0U, 65536U),
                             *rc::gen::inRange(1U, width + 1), *rc::gen::inRange(1U, height + 1)};
    const auto numbers =
        *rc::gen::container<std::vector<std::uint32_t>>(width * height, rc::gen::arbitrary<std::uint32_t>());
    std::vector<std::uint32_t> corner;
    for (std::uint32_t y = 0; y < region.height; ++y)
      for (std::uint32_t x = 0; x < region.width; ++x) corner.push_back(numbers[y * width + x]);

    pixel_square::OutputBuffer buffer(port_bits);
    RC_ASSERT(!buffer.busy());
    buffer.load(NumberedPixels(width, height, colour, numbers), colour, region);
    RC_ASSERT(testing::bits_of(sent(buffer), port_bits) ==
              testing::travelling(region, corner, colour.width, port_bits));
  }));
}

TEST_CASE("a square of 128 x 128 pixels of 24 bits takes 2 + 12288 words of 32 bits") {
  const isa::Field colour{0, 24};
  pixel_square::OutputBuffer buffer(32);
  buffer.load(NumberedPixels(128, 128, colour, std::vector<std::uint32_t>(128 * 128)), colour, {0, 0, 128, 128});
  CHECK(sent(buffer).size() == 2 + 12'288);
}
