#include "hw/pixel_square/screen.h"

#include <rapidcheck.h>

#include "hw/pixel_square/timing_screen.h"
#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;

namespace {

machines::Machine make_machine(const Figures& figures, std::uint64_t clock_hz) {
  machines::Machine machine = testing::square_machine(figures);
  machine.clock_hz = clock_hz;
  return machine;
}

isa::Program make_program(std::uint32_t width, std::uint32_t height, std::uint16_t colour_bits) {
  isa::Program program;
  program.shape = {width, height, 64};
  program.colour = {0, colour_bits};
  return program;
}

}  // namespace

TEST_CASE("a screen's turns are evenly spaced and read the picture row by row repeatedly") {
  // Two rows of 12 bits, read 9 bits per turn, take three turns per picture and 30 per second: at 100 clocks per
  // second, one every 3 1/3 clocks. They start with bits 0, 9 and 18.
  const Figures figures{.refresh_rate = 10, .refresh_bits = 9, .refresh_clocks = 2};
  Screen screen(figures, 100);
  screen.begin({4, 2}, 3);
  std::string rows;
  for (int edge = 1; edge <= 20; ++edge) {
    screen.advance(1);
    rows += screen.row() ? std::to_string(*screen.row()) : "-";
  }
  CHECK(rows == "---00-00-11--00-00-1");
}

TEST_CASE("a screen takes no turns with two pictures or without a rate or colours") {
  const Figures shown{.refresh_rate = 60, .refresh_bits = 8};
  Figures two = shown;
  two.pictures = 2;
  Figures none = shown;
  none.refresh_rate = pixel_square::not_shown;
  for (const auto& [figures, colour_bits] : {std::pair{two, 3U}, {none, 3U}, {shown, 0U}}) {
    Screen screen(figures, 10'000);
    screen.begin({4, 2}, colour_bits);
    CHECK_FALSE(screen.takes_turns());
    screen.advance(1);
    CHECK_FALSE(screen.row());
  }
}

TEST_CASE("ScreenTiming computes the turns of a stepped screen at every clock edge") {
  CHECK(rc::check([] {
    Figures figures;
    figures.refresh_rate = *rc::gen::inRange(1U, 100U);
    figures.refresh_bits = *rc::gen::inRange(1U, 300U);
    figures.refresh_clocks = *rc::gen::inRange(1U, 5U);
    figures.banks = *rc::gen::inRange(1U, 5U);
    figures.pictures = *rc::gen::weightedElement<std::uint32_t>({{9, 1}, {1, 2}});
    const machines::Size picture{*rc::gen::inRange(1U, 20U), *rc::gen::inRange(1U, 20U)};
    const auto colour_bits = *rc::gen::inRange<std::uint16_t>(0, 33);
    const std::uint64_t turns = figures.refresh_rate * pixel_square::turns_per_picture(picture, colour_bits, figures);
    const std::uint64_t clock_hz = turns * figures.refresh_clocks + *rc::gen::inRange<std::uint64_t>(1, 5000);
    Screen screen(figures, clock_hz);
    screen.begin(picture, colour_bits);
    const isa::Program program = make_program(picture.width, picture.height, colour_bits);
    pixel_square::ScreenTiming timing(program, make_machine(figures, clock_hz));
    pixel_square::ScreenTiming seldom_asked = timing;
    const auto seldom = *rc::gen::inRange<std::uint64_t>(2, 200);
    std::uint64_t clocks = 0;
    for (std::uint64_t edge = 1; edge < 500; ++edge) {
      screen.advance(1);
      const std::optional<std::uint32_t> row = screen.row();
      if (row) ++clocks;
      const std::optional<std::uint32_t> bank = row ? std::optional(*row % figures.banks) : std::nullopt;
      RC_ASSERT(timing.occupied_bank(edge) == bank);
      if (edge % seldom == 0) RC_ASSERT(seldom_asked.occupied_bank(edge) == bank);
      RC_ASSERT(timing.clocks_until(edge) == clocks);
    }
  }));
}

TEST_CASE("a screen that leaves no clock for drawing is rejected with a suggested fix") {
  // 24 bits in turns of 8: three turns of 10 clocks each, 60 times a second.
  const Figures figures{.refresh_rate = 60, .refresh_bits = 8, .refresh_clocks = 10};
  const isa::FrameHeader header = isa::frame_header(make_program(4, 2, 3));
  CHECK_NOTHROW(check_screen(header, make_machine(figures, 1801)));
  CHECK(
      testing::error_of([&] { check_screen(header, make_machine(figures, 1800)); }) ==
      "the screen takes 180 turns per second of 10 clocks each, but the frame buffer has 1800 clocks per second, which "
      "leaves none for drawing; increase refresh.bits, or set frame_buffer.pictures to 2");
}