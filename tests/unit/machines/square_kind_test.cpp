#include "hw/division/divide.h"
#include "hw/isa/host_counts.h"
#include "hw/kinds/load.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timeline.h"
#include "hw/pixel_square/storage_check.h"
#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

// Tests of the properties that the kind reports for its machines, and of the Programs they reject.

using namespace csgsim;
using namespace csgsim::testing::squares;
using testing::error_of;

namespace {

/// Returns a Program with one empty segment for each square of the machine's picture.
isa::Program whole_picture(const Machine& machine, std::uint16_t colour_bits = 3) {
  isa::Program program = make_program(colour_bits, {});
  program.shape = {machine.picture.width, machine.picture.height, 16};
  for (const isa::Region& region : machines::regions(machine))
    program.segments.push_back({.region = region, .instructions = {}});
  return program;
}

std::string refusal(const isa::Program& program, const Machine& machine) {
  return error_of([&] { machines::check_runs_on(program, machine); });
}

/// Returns the Program that a divider computes from the slab with a hole at the model's 16 x 16 pixels.
isa::Program divided_program(const Machine& machine) {
  isa::Program program = whole_picture(machine);
  program.display_model = model_bytes();
  testing::ModelDivider divider(testing::slab_with_hole());
  for (isa::Segment& segment : program.segments) segment.instructions = divider.divide(segment.region).instructions;
  return program;
}

}  // namespace

TEST_CASE("graphics processors share the host's work only if the divider is `processors`") {
  Machine machine = make_machine(2, {.processors = 7});
  machine.host.count = 3;
  CHECK(machine.kind->host_processor_count(machine) == 3);
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::corners;
  CHECK(machine.kind->host_processor_count(machine) == 3);
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::processors;
  CHECK(machine.kind->host_processor_count(machine) == 7);
}

TEST_CASE("only corner dividers divide the model and only two levels have groups") {
  Machine machine = make_machine(2, {.levels = 2, .group_side = 5, .list_entries = 9});
  const auto division = [&] { return machine.kind->division(machine); };
  CHECK_FALSE(division());
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::processors;
  CHECK_FALSE(division());
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::corners;
  REQUIRE(division());
  CHECK(division()->group_side == 5);
  CHECK(division()->list_entries == 9);
  machines::kind_figures<Figures>(machine).levels = 1;
  REQUIRE(division());
  CHECK(division()->group_side == 0);
  CHECK(division()->list_entries == 9);
}

TEST_CASE("a picture is halved in width and height alternately") {
  Machine machine = make_machine(8, {});
  machine.picture = {200, 100};
  const auto size = [&](std::uint32_t levels, machines::Parts parts) {
    const Machine cut = machine.kind->subdivided(machine, levels, parts).value();
    CHECK(cut.picture == machine.picture);
    return machines::Size{cut.array.width, cut.array.height};
  };
  using enum machines::Parts;
  CHECK(size(0, segments) == machines::Size{200, 100});
  CHECK(size(1, segments) == machines::Size{100, 100});
  CHECK(size(2, segments) == machines::Size{100, 50});
  CHECK(size(3, segments) == machines::Size{50, 50});
  CHECK(size(4, segments) == machines::Size{50, 25});
  CHECK(size(6, segments) == machines::Size{25, 13});  // 12.5, rounded up
  CHECK(size(7, segments) == machines::Size{13, 13});
  CHECK(size(0, subsegments) == machines::Size{50, 25});
  CHECK(size(1, subsegments) == machines::Size{25, 25});
  CHECK(size(2, subsegments) == machines::Size{25, 13});
}

TEST_CASE("pixels execute an instruction after the trees' latency and a query at once") {
  // The trees of 4 x 2 pixels have three levels.
  Machine machine = make_machine(4, {.has_global_or = true});
  machine.array.height = 2;
  isa::Program program = make_program(3, {square(2, {enable}), square(2, {})});
  program.segments[1].instructions = {
      enable, {.opcode = Opcode::skip_if_none, .constant = 1}, enable, {.opcode = Opcode::skip_if_none, .constant = 1}};
  machines::Timeline timeline;
  timeline.issued = {{{1, 2}}, {{3, 7}, {8, 15}, {0, 0}, {0, 0}}};
  CHECK(machines::spans_at_pixel(timeline, program, machine, 1, 0, 0) ==
        std::vector<machines::ClockSpan>{{6, 10}, {11, 12}, {0, 0}, {0, 0}});
}

TEST_CASE("a timeline reports when a square is cleared and its instructions are issued") {
  // Over a link as wide as a command, words reach the decoder at edges 2, 3, 4. The square is cleared for five clocks
  // from edge 3, clock 1, on; the instructions follow, of one clock and of three.
  Machine machine = make_machine(2, {.buffers = 2, .port_bits = 32, .port_fifo_depth = 8});
  machine.clear_clocks = 5;
  const isa::Program program = make_program(3, {square(2, {}), square(2, {enable, set({0, 3})})});
  const isa::Program alone = make_program(3, {program.segments[1]});
  const machines::Timeline timeline = machine.kind->timeline(alone, machine, {}).value();
  CHECK(timeline.cleared == std::vector<machines::ClockSpan>{{1, 6}});
  CHECK(timeline.issued == std::vector<std::vector<machines::ClockSpan>>{{{6, 7}, {7, 10}}});
  // The words follow two words of the header of a square that the frame buffer clears.
  const machines::Timeline later = machine.kind->timeline(program, machine, {}).value();
  CHECK(later.cleared == std::vector<machines::ClockSpan>{{0, 0}, {3, 8}});
  CHECK(later.issued == std::vector<std::vector<machines::ClockSpan>>{{}, {{8, 9}, {9, 12}}});
}

TEST_CASE("a query takes the clocks of the OR's gates and other instructions take none") {
  Machine machine = make_machine(4, {.has_global_or = true, .or_fan_in = 4});
  machine.array = {4, 2, 16};  // eight lines: two gates, and one gate for their outputs
  const isa::Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  const std::uint64_t gated = machine.kind->clocks(query, machine);
  CHECK(machine.kind->clocks(set({0, 3}), machine) == 3);
  machines::kind_figures<Figures>(machine).or_fan_in = 0;
  CHECK(machine.kind->clocks(query, machine) == gated - 2);
  CHECK(machine.kind->clocks(set({0, 3}), machine) == 3);
  // One pixel needs no gate.
  machine.array = {1, 1, 16};
  const std::uint64_t at_once = machine.kind->clocks(query, machine);
  machines::kind_figures<Figures>(machine).or_fan_in = 4;
  CHECK(machine.kind->clocks(query, machine) == at_once);
}

TEST_CASE("rejects global_or in any square of a pixel-square machine") {
  const Machine machine = make_machine(2, {.has_global_or = true});
  for (std::size_t segment = 0; segment < 4; ++segment) {
    for (std::size_t place = 0; place < 2; ++place) {
      isa::Program program = whole_picture(machine);
      program.segments[segment].instructions = {enable, enable, enable};
      CHECK(refusal(program, machine) == "");
      program.segments[segment].instructions[place] = {.opcode = Opcode::global_or};
      CHECK(refusal(program, machine)
                .starts_with("segment " + std::to_string(segment) + ", instruction " + std::to_string(place) +
                             ": global_or returns an answer to the host"));
    }
  }
}

TEST_CASE("a colour wider than the backing store is rejected") {
  const auto refused = [](std::uint32_t backing, std::uint16_t colour_bits) {
    const Machine machine = make_machine(2, {.backing_bits = backing});
    return refusal(whole_picture(machine, colour_bits), machine);
  };
  CHECK(refused(0, 16) == "");
  CHECK(refused(4, 4) == "");
  CHECK(refused(4, 3) == "");
  CHECK(refused(4, 5).starts_with("a pixel has 5 bits of colour, but the backing memory of squares holds 4"));
}

TEST_CASE("rejects a screen that takes all clocks and a display model that does not fit") {
  Machine machine = make_machine(2, {.refresh_rate = 10, .refresh_bits = 48, .refresh_clocks = 2});
  machine.clock_hz = 21;
  // A screen turn fetches 48 colour bits in two clocks, ten times a second.
  CHECK(refusal(whole_picture(machine), machine) == "");
  machine.clock_hz = 20;
  CHECK(refusal(whole_picture(machine), machine).starts_with("the screen takes 10 turns per second of 2 clocks each"));

  const Machine dividing_machine = make_machine(2, dividing());
  isa::Program program = whole_picture(dividing_machine);
  CHECK(refusal(program, dividing_machine) ==
        "the Program has no display model for squares to divide; compile the model for this machine");
  CHECK(refusal(program, make_machine(2, {})) == "");
  program.display_model = model_bytes();
  CHECK(refusal(program, dividing_machine) == "");
  Figures small = dividing();
  small.model_bits = 1;
  CHECK(refusal(program, make_machine(2, small)).starts_with("the display model has "));
  program.segments[3].division->steps = {{.cells = ~std::uint64_t{0}}};
  CHECK(refusal(program, dividing_machine).starts_with("the divider would test for more than"));
}

TEST_CASE("planes are read over the link only if the model exceeds the divider's memory") {
  const auto far = [](std::uint64_t bytes, std::uint64_t planes, std::uint64_t plane_bits) {
    return pixel_square::has_remote_planes(bytes, planes, plane_bits, {.model_bits = 80});
  };
  CHECK(far(11, 1, 1));
  CHECK_FALSE(far(10, 1, 1));  // all 80 bits
  CHECK_FALSE(far(11, 0, 1));
  CHECK_FALSE(far(11, 1, 0));
  CHECK(far(11, 100, 100));
}

TEST_CASE("any excess of half-spaces or nodes in a divider is rejected without overflow") {
  isa::Program program = make_program(3, {square(2, {})});
  program.display_model = model_bytes();
  program.segments[0].region = {4, 2, 2, 2};
  Figures figures = dividing();
  figures.halfspaces = 2;
  figures.nodes = 3;
  figures.model_bits = 4'000'000'000;
  // Multiplied by 266 or 98 bits these counts are multiples of 2^64.
  constexpr std::uint64_t many = std::uint64_t{1} << 63U;
  for (const isa::DivisionStep& surface :
       {isa::DivisionStep{.halfspaces = many + 2}, isa::DivisionStep{.nodes = many + 3}}) {
    program.segments[0].division->steps = {surface};
    CHECK(error_of([&] { pixel_square::check_storage(program, make_machine(2, figures)); })
              .starts_with("the square at 4,2 needs " + std::to_string(surface.halfspaces) + " half-spaces and " +
                           std::to_string(surface.nodes) + " tree nodes"));
  }
}

TEST_CASE("rejects a Program that differs from its division in one level and in two") {
  Figures figures = dividing();
  figures.group_side = 2;
  figures.list_entries = 100;
  for (const std::uint32_t levels : {1U, 2U}) {
    figures.levels = levels;
    Machine machine = make_machine(4, figures);
    machine.picture = {16, 16};
    isa::Program program = divided_program(machine);
    const auto refused = [&] { return error_of([&] { pixel_square::check_division(program, machine); }); };
    CHECK(refused() == "");
    // The slab is in the left half.
    REQUIRE(!program.segments[0].instructions.empty());
    program.segments[0].instructions.pop_back();
    CHECK(refused() == "segment 0 does not match the division of its display model; compile the model again");
    machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::host;
    CHECK(refused() == "");
  }
}

TEST_CASE("a group's first square includes the group's work if it has boxes or entries") {
  Figures figures = dividing();
  figures.levels = 2;
  figures.list_entries = 100;
  figures.box_clocks = 6;
  const auto clocks = [&](const isa::DivisionCounts& counts) {
    isa::Program program = make_program(3, {square(2, {})});
    program.display_model = model_bytes();
    *program.segments[0].division = counts;
    return time(program, make_machine(2, figures)).clocks;
  };
  const std::uint64_t none = clocks({});
  // A box is read in one clock and held in six; an entry is listed in one.
  CHECK(clocks({.steps = {}, .group_boxes = 5}) == none + 5 * 7);
  CHECK(clocks({.steps = {}, .group_entries = 9}) == none + 9);
  CHECK(clocks({.steps = {}, .group_boxes = 5, .group_entries = 9}) == none + 5 * 7 + 9);
}

TEST_CASE("ideal parameters of a pixel-square machine remove limits and take no clocks") {
  const auto own = [](const std::string& key) {
    return machines::kind_figures<Figures>(kinds::load("pixel-square+" + key + "=ideal"));
  };
  // Ideal: one gate, immediate latching, every plane moved, no screen, one channel per source.
  CHECK(own("global_or.fan_in").or_fan_in == 0);
  CHECK(own("renderers.move_bits").move_bits == pixel_square::all_planes);
  CHECK(own("renderers.latch_bits").latch_bits == pixel_square::no_latch);
  CHECK(own("backing.width").backing_width == pixel_square::all_planes);
  CHECK(own("refresh.rate").refresh_rate == pixel_square::not_shown);
  CHECK(own("ring.channels").ring_channels == pixel_square::all_channels);
  CHECK(own("divider.port").record_bits == 256);
  CHECK(own("divider.box_clocks").box_clocks == 0);
  CHECK(own("divider.halfspace_clocks").halfspace_clocks == 0);
  CHECK(own("divider.cell_clocks").cell_clocks == 0);
  CHECK(own("divider.node_clocks").node_clocks == 0);
  CHECK(own("divider.linear_clocks").linear_clocks == 0);
}

TEST_CASE("squares come in groups only if the machine's own dividers have two levels") {
  Figures figures = dividing();
  figures.group_side = 2;
  using Places = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const auto places = [&](pixel_square::DividerKind divider, std::uint32_t levels) {
    figures.divider = divider;
    figures.levels = levels;
    Machine machine = make_machine(1, figures);
    machine.picture = {4, 2};
    Places all;
    for (const isa::Region& region : machines::regions(machine)) all.emplace_back(region.x, region.y);
    return all;
  };
  const Places rows{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}};
  using enum pixel_square::DividerKind;
  CHECK(places(corners, 2) == Places{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {3, 0}, {2, 1}, {3, 1}});
  CHECK(places(corners, 1) == rows);
  CHECK(places(host, 2) == rows);
  CHECK(places(processors, 2) == rows);
}

TEST_CASE("Morton order visits squares along a Z and skips those outside the picture") {
  Machine machine = make_machine(1, {.order = pixel_square::SquareOrder::morton});
  machine.picture = {3, 5};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const isa::Region& region : machines::regions(machine)) all.emplace_back(region.x, region.y);
  CHECK(all == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0},
                                                                    {1, 0},
                                                                    {0, 1},
                                                                    {1, 1},
                                                                    {2, 0},
                                                                    {2, 1},
                                                                    {0, 2},
                                                                    {1, 2},
                                                                    {0, 3},
                                                                    {1, 3},
                                                                    {2, 2},
                                                                    {2, 3},
                                                                    {0, 4},
                                                                    {1, 4},
                                                                    {2, 4}});
}

TEST_CASE("rows are latched only if squares leave from the pixels' memory") {
  const isa::Program program = make_program(4, {square(2, {enable})});
  const auto clocks = [&](const Figures& figures) { return time(program, make_machine(2, figures)).clocks; };
  Figures one{.buffers = 1, .port_bits = 64, .port_fifo_depth = 8};
  Figures two = one;
  two.buffers = 2;
  Figures backing = one;
  backing.backing_bits = 8;
  const std::uint64_t at_once = clocks(one);
  CHECK(clocks(two) == at_once);
  for (Figures* const figures : {&one, &two, &backing}) figures->latch_bits = 1;
  // The header is one word and all 16 bits of colour are the next: it needs both rows of four planes. The first row
  // transfers in the fifth clock after the square is drawn, the second four clocks later, in place of the second clock.
  CHECK(clocks(one) == at_once + 9 - 2);
  CHECK(clocks(two) == at_once);
  Figures unlatched = backing;
  unlatched.latch_bits = pixel_square::no_latch;
  CHECK(clocks(backing) == clocks(unlatched));
}