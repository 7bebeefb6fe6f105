#include "hw/isa/colour_format.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("24 bits of colour hold 8 bits of each channel with red highest") {
  CHECK(isa::pack_colour({1.0, 0.5, 0.0}, 24) == 0xff8000U);
  CHECK(isa::unpack_colour(0x123456U, 24) == std::array<std::uint8_t, 3>{0x12, 0x34, 0x56});
}

TEST_CASE("extra colour bits go to green first and then to red") {
  CHECK(isa::channel_widths(3) == std::array<unsigned, 3>{1, 1, 1});
  CHECK(isa::channel_widths(8) == std::array<unsigned, 3>{3, 3, 2});
  CHECK(isa::channel_widths(16) == std::array<unsigned, 3>{5, 6, 5});
  CHECK(isa::channel_widths(24) == std::array<unsigned, 3>{8, 8, 8});
}

TEST_CASE("a colour is at most half a level off and black and white are exact") {
  for (unsigned bits = isa::minimum_colour_bits; bits <= isa::max_colour_bits; ++bits) {
    CAPTURE(bits);
    CHECK(isa::unpack_colour(isa::pack_colour({0, 0, 0}, bits), bits) == std::array<std::uint8_t, 3>{0, 0, 0});
    CHECK(isa::unpack_colour(isa::pack_colour({1, 1, 1}, bits), bits) == std::array<std::uint8_t, 3>{255, 255, 255});
    const std::array<unsigned, 3> widths = isa::channel_widths(bits);
    CHECK(widths[0] + widths[1] + widths[2] == bits);
    for (int level = 0; level <= 255; ++level) {
      const double part = level / 255.0;
      const std::array<std::uint8_t, 3> back = isa::unpack_colour(isa::pack_colour({part, part, part}, bits), bits);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int half_level = (255 / ((1 << widths[channel]) - 1) + 1) / 2;
        CHECK(std::abs(back[channel] - level) <= half_level);
      }
    }
  }
}