#include "hw/isa/host_counts.h"
#include "hw/pixel_square/timing_division.h"
#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

using namespace csgsim;
using namespace csgsim::testing::squares;
using testing::error_of;

TEST_CASE("a divider takes the model and tests a square before the square is sent") {
  isa::Program program = make_program(3, {square(2, {})});
  program.display_model = model_bytes();
  *program.segments[0].division = {.steps = {{.boxes = 2, .lists = 1, .halfspaces = 3, .cells = 5, .nodes = 7}}};
  const Machine machine = make_machine(2, dividing());
  // The model has two words of 256 bits; the last is taken at 3. Each node of the tree takes a clock; each box is read
  // and tested in two; a half-space and its plane are read in two clocks and tested in four: fourteen for three. Cells,
  // nodes and the word for an empty square follow.
  REQUIRE(program.display_model.size() > 32);
  REQUIRE(program.display_model.size() <= 64);
  constexpr std::uint64_t stored = 3 + 3 + 2 * 2 + 14 + 5 + 7 + 1;
  const Timing timing = time(program, machine);
  // The header leaves a clock later and is taken after another one; then a word of background is written.
  CHECK(timing.clocks == stored + 3);
  CHECK(timing.account.host == Clocks{2, 0, 0, 0, 0, stored + 1});
  CHECK(timing.account.dividers == std::vector<Clocks>{{stored - 1, 1, 0, 0, 0, 3}});
  CHECK(timing.account.sender == Clocks{1, 0, stored, 0, 0, 2});
}

TEST_CASE("half-spaces and nodes and planes beyond a divider's memories cost extra clocks") {
  isa::Program program = make_program(3, {square(2, {})});
  program.display_model = model_bytes();
  *program.segments[0].division = {.steps = {{.boxes = 1, .lists = 1, .halfspaces = 3, .cells = 5, .nodes = 7}}};
  const auto clocks = [&](const auto& change) {
    Machine machine = make_machine(2, dividing());
    machine.link.latency = 6;
    change(machines::kind_figures<Figures>(machine));
    return time(program, machine).clocks;
  };
  const std::uint64_t fits = clocks([](Figures&) {});
  // An entry has 251 bits and 15 places among 2: 266 bits, four words of 80. One is written, and five cells read it.
  CHECK(clocks([](Figures& own) { own.halfspaces = 2; }) == fits + (1 + 5) * 4);
  // Two nodes of 98 bits are written and read in two words each.
  CHECK(clocks([](Figures& own) { own.nodes = 5; }) == fits + 2 * 2 * 2);
  // A plane takes 6 + 1 clocks over the link; with the half-space's own clock that is 8 instead of 4, and 4 instead of
  // 2.
  CHECK(clocks([](Figures& own) { own.model_bits = 8; }) == fits + 3 * (8 - 4) + (4 - 2));
}

TEST_CASE("a square starts to leave when it is stored completely or fills the store") {
  isa::Program program = make_program(3, {square(2, {enable, enable, enable})});
  program.display_model = model_bytes();
  *program.segments[0].division = {.steps = {{.boxes = 100, .instructions = 2}, {.boxes = 100, .instructions = 1}}};
  const auto time_with = [&](std::uint32_t words) {
    Machine machine = make_machine(2, dividing());
    machines::kind_figures<Figures>(machine).store_words = words;
    return time(program, machine);
  };
  // SegmentStart, two instructions, 200 clocks of boxes, an instruction, SegmentEnd. With room for three words the
  // first three leave while the second surface is tested.
  const Timing whole = time_with(5);
  const Timing parts = time_with(3);
  CHECK(whole.account.sender.value().of(pixel_square::SquareActivity::working) == 5);
  CHECK(parts.account.sender.value().of(pixel_square::SquareActivity::working) == 5);
  const auto working = [](const Timing& timing) {
    return timing.account.dividers.front().of(pixel_square::SquareActivity::working);
  };
  CHECK(working(whole) == working(parts));
  // The square is cleared and its first two instructions are done when the third arrives.
  CHECK(parts.clocks < whole.clocks);
  // If there is room for one word each word waits until its predecessor has left, which takes one more clock.
  CHECK(time_with(1).account.dividers.front().of(pixel_square::SquareActivity::waiting_for_renderer) > 0);
}

TEST_CASE("two dividers halve the time of a frame that is limited by box tests") {
  isa::Program program = make_program(3, std::vector<isa::Segment>(4, square(2, {})));
  program.display_model = model_bytes();
  for (std::uint32_t i = 0; i < 4; ++i) {
    program.segments[i].region = {2 * (i % 2), i / 2 * 2, 2, 2};
    *program.segments[i].division = {.steps = {{.boxes = 500}}};
  }
  Machine machine = make_machine(2, dividing());
  const std::uint64_t one = time(program, machine).clocks;
  machines::kind_figures<Figures>(machine).dividers = 2;
  const Timing timing = time(program, machine);
  CHECK(timing.account.dividers.size() == 2);
  // The last two squares arrive together: the second's header waits a clock, and so does its background.
  CHECK(one - timing.clocks == 2 * (500 * 2 + 1) - 2);
}

TEST_CASE("a divider's tests whose clocks would overflow their counter are rejected") {
  isa::Program program = make_program(2, {square(1, {})});
  program.display_model.resize(1);
  program.segments[0].division->steps = {{.cells = ~std::uint64_t{0}}};
  CHECK(error_of([&] {
          pixel_square::check_countable(program, make_machine(1, {}));
        }).starts_with("the divider would test for more than"));
  program.segments[0].division->steps = {{.cells = std::uint64_t{1} << 36U}};
  program.segments.assign(1 << 5, program.segments[0]);
  CHECK_NOTHROW(pixel_square::check_countable(program, make_machine(1, {})));
  CHECK(error_of([&] {
          pixel_square::check_countable(program, make_machine(1, {.cell_clocks = 1'000'000}));
        }).starts_with("the divider would test for more than"));
}
