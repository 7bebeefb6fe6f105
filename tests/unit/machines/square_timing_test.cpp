#include "tests/unit/machines/square_timing.h"

#include <initializer_list>

#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/pixel_planes/kind.h"
#include "hw/scan_line/kind.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::testing::squares;
using testing::error_of;

TEST_CASE("a Program without squares takes no clock on a pixel-square machine") {
  const Timing timing = time(make_program(3, {}), make_machine(2, {}));
  CHECK(timing.clocks == 0);
  CHECK(timing.account.host == Clocks{});
}

TEST_CASE("an empty square costs its header and the words of its background") {
  // Eight words of header leave at 1 to 8 and are taken at 2 to 9; 12 bits are cleared at 10 and 11.
  const isa::Program program = make_program(3, {square(2, {})});
  const Timing timing = time(program, make_machine(2, {.port_bits = 8, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 11);
  CHECK(timing.account.squares_skipped == 1);
  CHECK(timing.account.host == Clocks{8, 0, 0, 0, 0, 3});
  CHECK(timing.account.frame_buffer == Clocks{10, 0, 0, 1, 0, 0});
  CHECK(timing.account.renderers == std::vector<Clocks>{{0, 0, 0, 0, 0, 11}});
}

TEST_CASE("a cleared Pixel-planes 5 square keeps a 32-bit port busy for 12288 clocks") {
  isa::Program program = make_program(24, {square(128, {})});
  program.shape = {128, 128, 208};
  const Timing timing = time(program, make_machine(128, {.port_bits = 32, .port_fifo_depth = 2}));
  CHECK(timing.clocks == 1 + 2 + 12'288);
}

TEST_CASE("a slow host's word leaves in the last of its clocks after the latency") {
  // The word leaves at 4 + 3 and is taken at 8; one word of background is written at 9.
  const isa::Program program = make_program(3, {square(2, {})});
  const Timing timing = time(
      program, make_machine(2, {.port_bits = 64}, {.width = 256, .word_clocks = 3, .fifo_depth = 1, .latency = 4}));
  CHECK(timing.clocks == 9);
  CHECK(timing.account.host == Clocks{3, 4, 0, 0, 0, 2});
}

TEST_CASE("a renderer's commands follow back to back and a square leaves word by word") {
  // Words leave the host at 1, 2, 3, 4 and the decoder takes them at 2, 3, 4, 5. The pixels' controller starts the
  // square at 3, the instructions at 4 and 5 (three clocks) and the end at 8, which arrives at 10. Two words of header
  // and one of colours leave at 11, 12, 13 and are stored at 12, 13, 14.
  const isa::Program program = make_program(3, {square(2, {enable, set({0, 3})})});
  for (const std::uint32_t buffers : {1U, 2U}) {
    const Timing timing = time(program, make_machine(2, {.buffers = buffers, .port_bits = 32, .port_fifo_depth = 8}));
    CHECK(timing.clocks == 14);
    CHECK(timing.account.squares_drawn == 1);
    CHECK(timing.account.host == Clocks{4, 0, 0, 0, 0, 10});
    const Clocks one_buffer{1 + 1 + 3 + 3, 0, 2, 0, 3, 1};
    const Clocks two_buffers{1 + 1 + 3 + 3, 0, 2, 0, 0, 4};
    CHECK(timing.account.renderers == std::vector<Clocks>{buffers == 1 ? one_buffer : two_buffers});
    CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 11, 0, 0});
  }
}

TEST_CASE("planes move to the second buffer a few per clock and clearing comes first") {
  // Same clocks, but three planes take two clocks, and the start takes five.
  const isa::Program program = make_program(3, {square(2, {enable, set({0, 3})})});
  Machine machine = make_machine(2, {.buffers = 2, .move_bits = 2, .port_bits = 32, .port_fifo_depth = 8});
  CHECK(time(program, machine).clocks == 16);
  machine.clear_clocks = 5;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 20);
  CHECK(timing.account.renderers == std::vector<Clocks>{{5 + 1 + 3 + 3 + 2, 0, 2, 0, 0, 4}});
}

TEST_CASE("a command of several words executes when its last word has arrived") {
  // The region of 70 bits takes three words, taken by the decoder at 2, 3, 4.
  const isa::Program program = make_program(3, {square(2, {enable, set({0, 3})})});
  Machine machine = make_machine(2, {.buffers = 2, .port_bits = 32, .port_fifo_depth = 8});
  machine.link.width = 32;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 16);
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 4, 0, 0, 4}});
}

TEST_CASE("a query waits for its answer and a dropped instruction takes one clock") {
  // The query executes at 4 and its answer arrives at 7. Then the instructions are dropped, the first at 7, and the
  // end executes in the clock after the last; each of its words takes as long as above.
  const Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  const machines::Skip none{.segment = 0, .index = 0};
  Machine machine = make_machine(2, {.buffers = 2, .port_bits = 32, .port_fifo_depth = 8, .has_global_or = true});
  for (std::uint64_t skipped = 1; skipped <= 3; ++skipped) {
    std::vector<Instruction> instructions(1 + skipped, set({0, 3}));
    instructions[0] = query;
    instructions[0].constant = skipped;
    const isa::Program program = make_program(3, {square(2, std::move(instructions))});
    CHECK(pixel_square::time_squares(program, machine, {{none}}).clocks == 14 + skipped - 1);
    CHECK(time(program, machine).clocks == 13 + 3 * skipped);
  }
  machines::kind_figures<Figures>(machine).or_fan_in = 2;
  const isa::Program program = make_program(3, {square(2, {query, set({0, 3})})});
  CHECK(pixel_square::time_squares(program, machine, {{none}}).clocks == 14 + 2);
  CHECK(machines::clocks(query, machine) == 1 + 2 + 2);
}

TEST_CASE("a FIFO of one place passes a word every other clock into and out of a renderer") {
  // Words leave the host at 1, 3, 5, 7 and are taken at 2, 4, 6, 8; the end executes at 10 and arrives at 12; words of
  // the square leave at 13, 15, 17.
  const isa::Program program = make_program(3, {square(2, {enable, set({0, 3})})});
  Machine machine = make_machine(2, {.buffers = 2, .port_bits = 32});
  machine.link.fifo_depth = 1;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 18);
  CHECK(timing.account.host == Clocks{4, 0, 0, 3, 0, 11});
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 4, 0, 0, 6}});
  CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 15, 0, 0});
}

TEST_CASE("a finished square waits until its predecessor has left the output buffer") {
  // The first square is drawn at 5 and leaves at 6 to 73; the second is drawn at 8, moves at 74 and leaves at 75 to
  // 142.
  const isa::Program program = make_program(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, make_machine(1, {.buffers = 2, .port_bits = 1, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 143);
  CHECK(timing.account.renderers == std::vector<Clocks>{{6, 0, 2, 0, 66, 69}});
  CHECK(timing.account.frame_buffer == Clocks{136, 0, 0, 7, 0, 0});
}

TEST_CASE("a backing store holds squares up to its bits and sends them back to back") {
  // The first square is drawn at 5. A square has 68 words; with a second buffer the next one moves there a clock after
  // its predecessor's last word and leaves from the following clock on.
  const isa::Program program = make_program(4, {square(1, {enable}), square(1, {enable}), square(1, {enable})});
  const auto time_with = [&](Figures figures) {
    figures.port_bits = 1;
    figures.port_fifo_depth = 8;
    return time(program, make_machine(1, figures));
  };
  CHECK(time_with({.buffers = 2}).clocks == 5 + 3 * 68 + 1 + 2);
  CHECK(time_with({.backing_bits = 8}).clocks == 5 + 3 * 68 + 1);
  CHECK(time_with({.backing_bits = 4}).clocks == time_with({.buffers = 2}).clocks);
  CHECK(time_with({.backing_bits = 8, .backing_width = 2}).clocks == 5 + 2 + 3 * 68 + 1);
  const auto waited = [&](std::uint32_t bits) {
    return time_with({.backing_bits = bits})
        .account.renderers.at(0)
        .of(pixel_square::SquareActivity::waiting_for_frame_buffer);
  };
  CHECK(waited(12) == 0);
  CHECK(waited(8) == 73 - 11 + 1);
  const Machine machine = make_machine(1, {.backing_bits = 3});
  isa::Program whole = make_program(4, {});
  for (const isa::Region& region : machines::regions(machine))
    whole.segments.push_back({.region = region, .instructions = {}});
  CHECK(
      error_of([&] { machines::check_runs_on(whole, machine); }) ==
      "a pixel has 4 bits of colour, but the backing memory of squares holds 3; increase backing.bits, or set it to 0 "
      "to use a second buffer");
}

TEST_CASE("a renderer with one buffer starts the next square when its predecessor has left") {
  // The first square is drawn at 5 and leaves at 6 to 73; the second starts at 74, ends at 76 and leaves at 77 to 144.
  const isa::Program program = make_program(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, make_machine(1, {.buffers = 1, .port_bits = 1, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 145);
  CHECK(timing.account.renderers == std::vector<Clocks>{{6, 0, 2, 0, 136, 1}});
}

TEST_CASE("a square goes to the renderer with the fewest unfinished squares") {
  // The first square keeps renderer 0 busy until 14; the second leaves at 7, 8, 9 and is finished at 11. Clearing words
  // leave from 10 on. The last square leaves at 11, before this is known, or at 12.
  const isa::Segment slow = square(1, {enable, set({0, 3}), set({0, 3}), set({0, 3})});
  const isa::Segment quick = square(1, {enable});
  const isa::Segment nothing = square(1, {});
  const Machine machine = make_machine(1, {.renderers = 2, .buffers = 2, .port_bits = 64, .port_fifo_depth = 9});
  CHECK(time(make_program(2, {slow, quick, nothing, quick}), machine).account.renderer_squares ==
        std::vector<std::uint64_t>{2, 1});
  CHECK(time(make_program(2, {slow, quick, nothing, nothing, quick}), machine).account.renderer_squares ==
        std::vector<std::uint64_t>{1, 2});
}

TEST_CASE("renderers take turns at the frame buffer word by word") {
  // Squares are drawn at 5 + 2 and 8 + 2. Eighty words from 8 on, 68 from 11 on; every clock from 9 on stores one.
  const isa::Program program = make_program(4, {square(2, {enable}), square(1, {enable})});
  const Timing timing =
      time(program, make_machine(2, {.renderers = 2, .buffers = 2, .port_bits = 1, .port_fifo_depth = 32}));
  CHECK(timing.clocks == 8 + 80 + 68);
  CHECK(timing.account.frame_buffer == Clocks{148, 0, 0, 8, 0, 0});
}

TEST_CASE("rejects a global-OR query on machines without the OR and suggests an alternative") {
  isa::Program program = make_program(2, {square(1, {enable, {.opcode = Opcode::global_or}})});
  for (const machines::Kind* const kind :
       std::initializer_list<const machines::Kind*>{&scan_line::kind, &pixel_square::kind}) {
    Machine machine = machines::blank_machine(*kind);
    machine.name = "squares";
    CHECK(error_of([&] { machines::check_runs_on(program, machine); }) ==
          "segment 0, instruction 1: global_or needs a global OR, which the machine squares does not have; compile the "
          "model for this machine, or use one with global_or.present = 1");
  }
  CHECK_NOTHROW(machines::check_runs_on(program, machines::blank_machine(pixel_planes::kind)));
}

TEST_CASE("renderers with an OR skip instructions but send no answers to the host") {
  isa::Program program = make_program(2, {});
  Machine machine = make_machine(2, {.has_global_or = true});
  for (const isa::Region& region : machines::regions(machine))
    program.segments.push_back({.region = region, .instructions = {}});
  program.segments[1].instructions = {{.opcode = Opcode::skip_if_none, .constant = 1}, enable};
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  CHECK(machines::has_global_or(machine));
  program.segments[1].instructions[1] = {.opcode = Opcode::global_or};
  CHECK(error_of([&] { machines::check_runs_on(program, machine); }) ==
        "segment 1, instruction 1: global_or returns an answer to the host, but the renderers of squares cannot send "
        "one; omit global_or, or use a machine of kind frame-buffer, such as pixel-planes-4");
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::corners;
  CHECK_FALSE(machines::has_global_or(machine));
}

TEST_CASE("a Program whose segments are not the machine's squares is rejected") {
  const Machine machine = make_machine(2, {});
  isa::Program program = make_program(2, {});
  for (const isa::Region& region : machines::regions(machine)) {
    program.segments.emplace_back().region = region;
  }
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  std::swap(program.segments[0], program.segments[1]);
  CHECK(error_of([&] {
          machines::check_runs_on(program, machine);
        }).starts_with("the Program's segments are not the 4 regions that squares uses for a picture of 4x4"));
}
