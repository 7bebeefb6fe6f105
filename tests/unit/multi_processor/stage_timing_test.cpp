#include "tests/unit/multi_processor/stage_timing.h"

#include <rapidcheck.h>

#include "hw/isa/host_counts.h"
#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::testing::stages;

TEST_CASE("each stage of a frame takes the hand-counted clocks") {
  const Machine machine = machine_4x4();
  const FrameAccount account = account_of(program_for(machine), machine);
  CHECK(program_for(machine).display_model.size() == 59);
  CHECK(account.model_words == 32);
  CHECK(account.stages.reception == 5 + 32 * 3);
  CHECK(account.stages.transformation == 3 * 43);
  CHECK(account.stages.first_pruning == 2 * 37 + 3 * 41 + 2 * 61);
  // A header of 256 bits, two primitives of 75 and three nodes of 4; then 70 bits begin the segment and 6 end it, with
  // 2 bits for the number of remaining primitives, 3 for the primitive, 12 for each half-space.
  CHECK(account.broadcast_words == 8 + 2 * 3 + 3 + 3 + 1 + 1 + 1 + 3);
  CHECK(account.stages.broadcasting == 4 + 17 * 10 + 4 + 9 * 10);
  CHECK(account.stages.second_pruning == 29 + 3 * 31 + 47 + 2 * 53 + 2 * 59);
  CHECK(spent(account, NodeActivity::pruning) == account.stages.second_pruning + 3 * 29);
  // An instruction of 6 bits and one of 6 + 18 + 12 + 60.
  CHECK(account.shared_words == 4 * (3 + 1) + 1 + 3);
  CHECK(account.stages.sharing == 4 * 4 + 20 * 10);
  CHECK(account.stages.barriers == 5 * 6);
  const std::uint64_t clear = 2 * 3 + 17 + 19;
  const std::uint64_t enable = (23 + 2) + (2 + 11 + 3) + 17 + 19;
  const std::uint64_t begin = 4 * 2 * 13 + 2 * 2 * 5;
  // Two words shifted by 4 places, and the bits entering the lower one.
  const std::uint64_t shift = 2 * (67 + 4 * 71) + (67 + 12 * 71 + 11);
  const std::uint64_t at_pixel = 2 * 5 + shift + 2 + 11 + 3 + 2 * 7 + 3;
  const std::uint64_t load = (23 + 6 * 2) + begin + 2 * 5 + at_pixel + 17 + 19;
  const std::uint64_t store = 2 + 3 + 17 + 19;
  const std::uint64_t background = 3 + 17 + 19;
  CHECK(account.stages.rendering == clear + enable + load + store + 3 * background);
  CHECK(clocks_of(program_for(machine), machine) == 3613);
}

TEST_CASE("each rendering order takes the hand-counted clocks of its loop over pixels") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  figures(machine).order = RenderingOrder::scan_line;
  CHECK(clocks_of(program, machine) == 3558);
  figures(machine).order = RenderingOrder::pixel;
  CHECK(clocks_of(program, machine) == 3505);
}

TEST_CASE("unpacking records adds fields and shifts and masks to pruning (hand calculation)") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).field_clocks = 73;
  const FrameAccount account = account_of(program, machine);
  const auto shift = [](std::uint64_t places) { return 67 + 71 * places; };
  // Four sides of 15 bits at offsets 0, 15, 30 and 45, two depths of 5; each has a mask, and all but the first and the
  // last cross a word boundary.
  const std::uint64_t box = 6 * (73 + 11) + shift(15) + (shift(1) + 11) + shift(14) + (shift(2) + 11) + shift(13) +
                            (shift(3) + 11) + shift(12) + (shift(4) + 11) + shift(1);
  CHECK(account.nodes[1].of(NodeActivity::pruning) == 29 + box);
  // Three half-spaces: two bits, A and B of 2 bits, C of 3; two nodes of the tree: two bits, and 2.
  const std::uint64_t halfspace = 5 * (73 + 11) + shift(1) + shift(2) + shift(4) + shift(6);
  const std::uint64_t node = 3 * (73 + 11) + shift(1) + shift(2);
  CHECK(account.nodes[0].of(NodeActivity::pruning) ==
        before.nodes[0].of(NodeActivity::pruning) + box + 3 * halfspace + 2 * node);
}

TEST_CASE("a frame waits for the node with the slowest pixels (hand calculation)") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).branches = {.over = multi_processor::Branches::pixels, .taken = 101, .passed = 103};
  // Each node has a pixel of the first subsegment. E is 1 at the second's pixel when F is loaded.
  std::vector<machines::PixelActivity> pixel_activity(program.segments.size());
  pixel_activity[0] = {.row_words = 1, .planes = {{}, {0b10, 0}}, .instructions = {{0, 0}, {1, 1}}};
  const FrameAccount account = multi_processor::time_stages(program, machine, pixel_activity).account;
  CHECK(account.stages.rendering == before.stages.rendering + 103);
  const std::uint64_t shift = 2 * (67 + 4 * 71) + (67 + 12 * 71 + 11);
  const std::uint64_t over = shift + 3 + 2 * 7 + 3;  // the shift, the fields written, the range check of F
  const auto rendering = [&](std::size_t node) { return account.nodes[node].of(NodeActivity::rendering); };
  CHECK(rendering(1) == before.nodes[1].of(NodeActivity::rendering) + 103);
  for (const std::size_t node : {0U, 2U, 3U})
    CHECK(rendering(node) == before.nodes[node].of(NodeActivity::rendering) - over + 101);
  // If no enables are recorded each pixel may take the maximum.
  CHECK(account_of(program, machine).stages.rendering == account.stages.rendering);
}

TEST_CASE("with half-space numbers each node computes the expressions (hand calculation)") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).lists = multi_processor::ListKind::numbers;
  figures(machine).number_clocks = 1000;
  const FrameAccount account = account_of(program, machine);
  // Three half-spaces; 6 + 18 + 1 + 2 + 6 bits are two words of 32 and three of 16, instead of three and six.
  CHECK(account.shared_words == before.shared_words - 1);
  CHECK(account.stages.second_pruning == before.stages.second_pruning + 1000 - 59);
  // A record of 12 bits takes one word.
  CHECK(account.stages.rendering == before.stages.rendering - 3 * 2 + 2 + 59);
  figures(machine).chain = {.program = multi_processor::NodeProgram::native, .link = 100, .call = 10};
  // enable_all writes nothing; the other instruction writes 12 + 6 bits of its field, and 12 + 60 of the expression.
  CHECK(account_of(program, machine).stages.rendering == account.stages.rendering + 2 * 100 + 10 * 3 + 2 * 10 + 10 * 2);
}

TEST_CASE("an empty segment of a multi-processor is only set to the background") {
  const Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  program.segments[0].instructions.clear();
  for (isa::Segment& segment : program.segments) *segment.division = {.steps = {}, .group_boxes = 2};
  const FrameAccount account = account_of(program, machine);
  CHECK(account.active_segments == 0);
  CHECK(account.broadcast_words == 17 + 4);
  CHECK(account.shared_words == 0);
  CHECK(account.stages.rendering == 4 * (3 + 17) + 2 * 19);
  CHECK(account.stages.barriers == 6);
}

TEST_CASE("all nodes wait for the one with the most pixels") {
  Machine machine = machine_4x4();
  machine.picture = {3, 1};
  isa::Program program = program_for(machine);
  const FrameAccount account = account_of(program, machine);
  // Two subsegments, of two pixels and of one; nodes of the second row have none.
  CHECK(account.nodes[2].of(NodeActivity::rendering) == 0);
  const NodeClocks& first = account.nodes[0];
  const NodeClocks& second = account.nodes[1];
  CHECK(first.of(NodeActivity::rendering) == second.of(NodeActivity::rendering) + 3 + 17 + 19);
  CHECK(account.stages.rendering == first.of(NodeActivity::rendering));
}

TEST_CASE("a frame takes at least its shared work and at most the sum of all work") {
  CHECK(rc::check([] {
    const Machine machine = random_machine();
    const isa::Program program = any_program(machine);
    const multi_processor::FrameClocks frame = multi_processor::time_stages(program, machine);
    const FrameAccount& account = frame.account;
    const multi_processor::StageClocks& stages = account.stages;
    std::uint64_t at_pixels = 0;
    for (const isa::Segment& segment : program.segments) {
      at_pixels +=
          std::uint64_t{segment.region.width} * segment.region.height * machines::clocks(segment.instructions, machine);
    }
    const std::uint64_t rendered = spent(account, NodeActivity::rendering);
    const std::uint64_t bus = stages.broadcasting + stages.sharing;
    RC_ASSERT(rendered >= at_pixels);
    const std::uint64_t alone = stages.reception + stages.transformation + stages.first_pruning + bus;
    RC_ASSERT(frame.clocks >= alone + at_pixels / account.nodes.size());
    RC_ASSERT(frame.clocks <= alone + spent(account, NodeActivity::pruning) + rendered + stages.barriers);
    RC_ASSERT(account.display.total() == frame.clocks);
    RC_ASSERT(account.bus.total() == frame.clocks);
    for (const NodeClocks& node : account.nodes) RC_ASSERT(node.total() == frame.clocks);
    RC_ASSERT(bus >= (account.broadcast_words + account.shared_words) * machine.link.word_clocks);
  }));
}

TEST_CASE("a wider host link or bus never adds clocks to a multi-processor's frame") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    const isa::Program program = any_program(machine);
    const std::uint64_t narrow = clocks_of(program, machine);
    machine.link.width += *rc::gen::inRange<std::uint32_t>(1, 100);
    const std::uint64_t wide = clocks_of(program, machine);
    figures(machine).host.width += *rc::gen::inRange<std::uint32_t>(1, 100);
    RC_ASSERT(wide <= narrow);
    RC_ASSERT(clocks_of(program, machine) <= wide);
  }));
}

TEST_CASE("dividing ahead saves at most the first pruning of all segments but the first") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    const isa::Program program = any_program(machine);
    const std::uint64_t behind = clocks_of(program, machine);
    figures(machine).divides_ahead = true;
    const std::uint64_t ahead = clocks_of(program, machine);
    RC_ASSERT(ahead <= behind);
    RC_ASSERT(ahead + account_of(program, machine).stages.first_pruning >= behind);
    if (account_of(program, machine).segment_count == 1) RC_ASSERT(ahead == behind);
  }));
}

TEST_CASE("a frame of a multi-processor longer than SystemC's time is rejected") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  machine.clock_hz = 1;
  figures(machine).transform_clocks = 1'000'000;
  CHECK_THROWS_AS(machines::check_runs_on(program, machine), InputError);
  program.segments[0].division->steps = {{.cells = ~0ULL}};
  machine.clock_hz = 1'000'000'000;
  CHECK_THROWS_AS(machines::check_runs_on(program, machine), InputError);
}