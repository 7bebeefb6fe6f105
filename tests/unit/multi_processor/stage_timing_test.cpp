#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/encoding.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/refresh.h"
#include "hw/multi_processor/timing.h"
#include "tests/support/random_program.h"

using namespace csgsim;
using isa::Opcode;
using machines::Machine;
using multi_processor::Figures;
using multi_processor::FrameAccount;
using multi_processor::NodeActivity;
using multi_processor::NodeClocks;
using multi_processor::RenderingOrder;

namespace {

/// 2 x 2 nodes, a segment of 4 x 4 pixels, and clocks that are told from each other in a sum.
Machine machine_4x4() {
  Machine machine = machines::blank(multi_processor::kind);
  machine.name = "four";
  machine.array = {2, 2, 16};
  machine.picture = {4, 4};
  machine.clock_hz = 8'000'000;
  machine.link = {.width = 32, .word_clocks = 10, .fifo_depth = 1, .latency = 4};
  machine.own = Figures{
      .levels = 0,
      .order = RenderingOrder::segment,
      .word_bits = 16,
      .memory_words = 1000,
      .operations =
          {.read = 2, .write = 3, .add = 5, .compare = 7, .logic = 11, .multiply = 13, .shift = 67, .shift_bit = 71},
      .loop = {.pixel = 17, .row = 19, .instruction = 23},
      .node_tests = {.primitive = 29, .halfspace = 31, .cell = 47, .tree_node = 53, .instruction = 59},
      .display_tests = {.primitive = 37, .halfspace = 41, .cell = 61},
      .host = {.width = 16, .word_clocks = 3, .latency = 5},
      .display_memory_words = 1000,
      .transform_clocks = 43,
      .divides_ahead = false,
      .barrier_clocks = 6};
  return machine;
}

Figures& figures(Machine& machine) { return machines::own<Figures>(machine); }

/// Two primitives of five half-spaces on three planes: 264 bits of header, 3 planes of 8, 2 primitives of 77, 5
/// half-spaces of 3 bits, of which 3 have a colour of 3 bits, and nodes of 1, 1 and 4 bits: 59 bytes.
std::vector<std::uint8_t> model_bytes() {
  division::DisplayModel model;
  model.width = 4;
  model.height = 4;
  model.z_bits = 4;
  model.colour_bits = 3;
  model.fields = {.depth = {0, 4}, .candidate = {4, 4}, .colour = {8, 3}, .candidate_colour = {}, .mask = {11, 1}};
  model.planes = {{false, 1, 0, 3}, {false, 0, 1, 3}, {false, 1, 1, 3}};
  const division::Box box{{0, 0, 3, 3}, 0, 15};
  model.primitives = {{{box, false, false, 1}, {{0, true, 1}, {1, true, 2}, {2, false, 0}}},
                      {{box, false, false, 1}, {{0, true, 3}, {1, false, 0}}}};
  model.nodes = {{}, {}, {2, division::Operator::unite}};
  const division::Bits bits = division::encode(model);
  std::vector<std::uint8_t> bytes((bits.count + 7) / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(bits.words[i / 8] >> (i % 8 * 8) & 0xffU);
  return bytes;
}

/// Of which one primitive is left for the segment, with three half-spaces; two instructions come of it in the first
/// subsegment.
isa::Program program_for(const Machine& machine) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 16};
  program.colour = {0, 8};
  program.display_model = model_bytes();
  for (const isa::Region& region : machines::regions(machine)) program.segments.push_back({region, {}});
  isa::Segment& first = program.segments.front();
  first.instructions.push_back({.opcode = Opcode::enable_all});
  first.instructions.push_back(
      {.opcode = Opcode::load_linear, .fields = {isa::Field{0, 8}}, .linear = {1, 2, 3, 20, 4}});
  for (isa::Segment& segment : program.segments) segment.division.steps = {{.boxes = 1}};
  first.division = {.steps = {{.boxes = 1, .halfspaces = 3, .cells = 1, .nodes = 2, .instructions = 2}},
                    .group_boxes = 2,
                    .group_halfspaces = 3,
                    .group_cells = 2,
                    .group_entries = 1 + 3};
  return program;
}

FrameAccount account_of(const isa::Program& program, const Machine& machine) {
  return multi_processor::time_stages(program, machine).account;
}

std::uint64_t clocks_of(const isa::Program& program, const Machine& machine) {
  return multi_processor::time_stages(program, machine).clocks;
}

std::uint64_t spent(const FrameAccount& account, NodeActivity activity) {
  return std::accumulate(account.nodes.begin(), account.nodes.end(), std::uint64_t{0},
                         [activity](std::uint64_t sum, const NodeClocks& node) { return sum + node.of(activity); });
}

Machine random_machine() {
  const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
  Machine machine = machine_4x4();
  machine.array = {1 + below(4), 1 + below(4), 40};
  machine.picture = {1 + below(24), 1 + below(24)};
  machine.link = {.width = 1 + below(70), .word_clocks = 1 + below(9), .fifo_depth = 1, .latency = below(20)};
  figures(machine).memory_words = 1U << 30U;
  figures(machine).levels = below(5);
  figures(machine).order = static_cast<RenderingOrder>(below(3));
  figures(machine).word_bits = 1 + below(64);
  figures(machine).display_tests = {below(60), below(600)};
  figures(machine).display_memory_words = 1U << 30U;
  figures(machine).host = {1 + below(70), 1 + below(9), below(20)};
  figures(machine).barrier_clocks = below(50);
  return machine;
}

/// Instructions and counts are what they may be, not what anything is divided into.
isa::Program any_program(const Machine& machine) {
  const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
  isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
  program.display_model = model_bytes();
  for (isa::Segment& segment : program.segments)
    segment.division = {.steps = {{.boxes = below(3),
                                   .halfspaces = below(20),
                                   .cells = below(20),
                                   .nodes = below(5),
                                   .instructions = segment.instructions.size()}},
                        .group_boxes = below(3),
                        .group_halfspaces = below(9),
                        .group_cells = below(30)};
  return program;
}

}  // namespace

TEST_CASE("each stage of a frame takes what a hand calculation says") {
  const Machine machine = machine_4x4();
  const FrameAccount account = account_of(program_for(machine), machine);
  CHECK(program_for(machine).display_model.size() == 59);
  CHECK(account.model_words == 32);
  CHECK(account.stages.reception == 5 + 32 * 3);
  CHECK(account.stages.transformation == 3 * 43);
  CHECK(account.stages.first_pruning == 2 * 37 + 3 * 41 + 2 * 61);
  // A header of 256 bits, two primitives of 75 and three nodes of 4; then 70 bits begin the segment and 6 end it, with
  // 2 bits that say how many are left, 3 for the primitive, 12 for each half-space.
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
  // Two words by 4 places, and what comes into the lower one.
  const std::uint64_t shift = 2 * (67 + 4 * 71) + (67 + 12 * 71 + 11);
  const std::uint64_t at_pixel = 2 * 5 + shift + 2 + 11 + 3 + 2 * 7 + 3;
  const std::uint64_t load = (23 + 6 * 2) + begin + 2 * 5 + at_pixel + 17 + 19;
  const std::uint64_t store = 2 + 3 + 17 + 19;
  const std::uint64_t background = 3 + 17 + 19;
  CHECK(account.stages.rendering == clear + enable + load + store + 3 * background);
  CHECK(clocks_of(program_for(machine), machine) == 3613);
}

TEST_CASE("the order of rendering changes what goes round the pixels: hand calculations") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  figures(machine).order = RenderingOrder::scan_line;
  CHECK(clocks_of(program, machine) == 3558);
  figures(machine).order = RenderingOrder::pixel;
  CHECK(clocks_of(program, machine) == 3505);
}

TEST_CASE("a node unpacks what it looks at as it divides: a hand calculation") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).field_clocks = 73;
  const FrameAccount account = account_of(program, machine);
  const auto shift = [](std::uint64_t places) { return 67 + 71 * places; };
  // Four sides of 15 bits from places 0, 15, 30 and 45 on, two depths of 5; each has a mask, and all but the first and
  // the last end in another word than they begin in.
  const std::uint64_t box = 6 * (73 + 11) + shift(15) + (shift(1) + 11) + shift(14) + (shift(2) + 11) + shift(13) +
                            (shift(3) + 11) + shift(12) + (shift(4) + 11) + shift(1);
  CHECK(account.nodes[1].of(NodeActivity::pruning) == 29 + box);
  // Three half-spaces: two bits, A and B of 2 bits, C of 3; two nodes of the tree: two bits, and 2.
  const std::uint64_t halfspace = 5 * (73 + 11) + shift(1) + shift(2) + shift(4) + shift(6);
  const std::uint64_t node = 3 * (73 + 11) + shift(1) + shift(2);
  CHECK(account.nodes[0].of(NodeActivity::pruning) ==
        before.nodes[0].of(NodeActivity::pruning) + box + 3 * halfspace + 2 * node);
}

TEST_CASE("the node with the pixels that take most is waited for: a hand calculation") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).branches = {.over = multi_processor::Branches::pixels, .taken = 101, .passed = 103};
  // Each node has a pixel of the first subsegment. E is 1 at that of the second when F is loaded.
  std::vector<machines::MetPixels> met(program.segments.size());
  met[0] = {.row_words = 1, .planes = {{}, {0b10, 0}}, .instructions = {{0, 0}, {1, 1}}};
  const FrameAccount account = multi_processor::time_stages(program, machine, met).account;
  CHECK(account.stages.rendering == before.stages.rendering + 103);
  const std::uint64_t shift = 2 * (67 + 4 * 71) + (67 + 12 * 71 + 11);
  const std::uint64_t over = shift + 3 + 2 * 7 + 3;  // the shift, the fields written, whether F fits
  const auto rendering = [&](std::size_t node) { return account.nodes[node].of(NodeActivity::rendering); };
  CHECK(rendering(1) == before.nodes[1].of(NodeActivity::rendering) + 103);
  for (const std::size_t node : {0U, 2U, 3U})
    CHECK(rendering(node) == before.nodes[node].of(NodeActivity::rendering) - over + 101);
  // Nobody knows: then each pixel may take as long as any.
  CHECK(account_of(program, machine).stages.rendering == account.stages.rendering);
}

TEST_CASE("where numbers of half-spaces travel each node works out their expressions: a hand calculation") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount before = account_of(program, machine);
  figures(machine).lists = multi_processor::ListKind::numbers;
  figures(machine).number_clocks = 1000;
  const FrameAccount account = account_of(program, machine);
  // Of 3 half-spaces; 6 + 18 + 1 + 2 + 6 bits are two words of 32 and three of 16, not three and six.
  CHECK(account.shared_words == before.shared_words - 1);
  CHECK(account.stages.second_pruning == before.stages.second_pruning + 1000 - 59);
  // A record of 12 bits is a word.
  CHECK(account.stages.rendering == before.stages.rendering - 3 * 2 + 2 + 59);
  figures(machine).chain = {.program = multi_processor::NodeProgram::native, .link = 100, .call = 10};
  // Of enable_all nothing is written; of the other 12 + 6 bits of its field, and 12 + 60 of the expression.
  CHECK(account_of(program, machine).stages.rendering == account.stages.rendering + 2 * 100 + 10 * 3 + 2 * 10 + 10 * 2);
}

TEST_CASE("a segment of which nothing is left is neither pruned by the nodes nor shared, only set to the background") {
  const Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  program.segments[0].instructions.clear();
  for (isa::Segment& segment : program.segments) segment.division = {.steps = {}, .group_boxes = 2};
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

TEST_CASE("no frame takes less than its shares of the work, nor more than all of it one after the other") {
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

TEST_CASE("a wider link, of the host or of the bus, never costs clocks") {
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

TEST_CASE("dividing ahead saves no more than the first pruning of all segments but the first") {
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

TEST_CASE("lists that do not fit the nodes at once are sent and rendered in parts: a hand calculation") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount whole = account_of(program, machine);
  CHECK(whole.list_passes == 1);
  // In words of 16 bits: the frame's 16 + 2 * 5 + 3, the segment's 1 + 1 + 3; lists begin with 5 and end with 1,
  // instructions are 1 and 6. Who sends stops where fewer than 16 words are left of 32 beside the 6 of a list that
  // waits: before the first list's end, and, as the last waits, before that of the third, of which no instruction came.
  figures(machine).memory_words = 34 + 32;
  const FrameAccount account = account_of(program, machine);
  CHECK(account.list_passes == 3);
  CHECK(account.shared_words == whole.shared_words + 2);
  CHECK(account.stages.sharing == 6 * 4 + 22 * 10);
  CHECK(account.stages.barriers == whole.stages.barriers + 2 * 6);
  CHECK(account.stages.second_pruning == whole.stages.second_pruning);
  CHECK(account.stages.rendering == whole.stages.rendering);
  CHECK(clocks_of(program, machine) == 3613 + 2 * 4 + 2 * 10 + 2 * 6);
}

TEST_CASE("a list that is more than half of what is left of a node's memory is made in parts: a hand calculation") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  isa::Segment& first = program.segments.front();
  first.instructions.push_back(first.instructions.back());
  first.division.steps.front().instructions = 3;
  const FrameAccount whole = account_of(program, machine);
  figures(machine).memory_words = 34 + 32;
  const FrameAccount account = account_of(program, machine);
  // 5 + 1 + 6 words of 16, then 6 + 1; meanwhile the other lists wait.
  const std::uint64_t before = 29 + 3 * 31 + 47 + 2 * 53 + 2 * 59;
  CHECK(whole.stages.second_pruning == before + 59);
  CHECK(account.stages.second_pruning == before + 59);
  CHECK(account.nodes[0].of(NodeActivity::pruning) == before + 59);
  CHECK(account.stages.sharing > whole.stages.sharing);
  CHECK(account.stages.rendering == whole.stages.rendering);
}

TEST_CASE("what is sent and rendered in parts takes longer, the more the smaller the memory is, and is all done") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    const isa::Program program = any_program(machine);
    const FrameAccount whole = account_of(program, machine);
    figures(machine).memory_words = *rc::gen::inRange<std::uint32_t>(100, 5000);
    try {
      machines::check_runs_on(program, machine);
    } catch (const InputError&) {
      return;
    }
    const FrameAccount parts = account_of(program, machine);
    RC_ASSERT(parts.list_passes >= whole.list_passes);
    RC_ASSERT(parts.shared_words >= whole.shared_words);
    RC_ASSERT(parts.stages.rendering >= whole.stages.rendering);
    RC_ASSERT(parts.stages.second_pruning >= whole.stages.second_pruning);
    RC_ASSERT(spent(parts, NodeActivity::pruning) >= spent(whole, NodeActivity::pruning));
    RC_ASSERT(parts.second_halfspace_tests == whole.second_halfspace_tests);
    RC_ASSERT(clocks_of(program, machine) >= parts.stages.rendering + parts.stages.second_pruning);
  }));
}

TEST_CASE(
    "half-spaces that do not fit the nodes are read over the bus, by one node after another: a hand calculation") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const FrameAccount whole = account_of(program, machine);
  // A word less than the records, 34, and two commands of at most 256 bits.
  figures(machine).memory_words = 34 + 32 - 1;
  const FrameAccount account = account_of(program, machine);
  // Three half-spaces are tested: a request and an answer of a word each, both after the bus's latency.
  const std::uint64_t reads = 3 * 2 * (4 + 10);
  CHECK(account.stages.second_pruning == whole.stages.second_pruning + reads + 3 * 29);
  CHECK(account.stages.broadcasting == whole.stages.broadcasting - 3 * 10);
  CHECK(account.broadcast_words == whole.broadcast_words);
  CHECK(account.broadcast_halfspaces == 3);
  CHECK(account.shared_words == whole.shared_words + 3);
  CHECK(account.list_passes == 4);
  CHECK(account.stages.sharing == whole.stages.sharing);
  CHECK(account.stages.rendering == whole.stages.rendering);
  CHECK(clocks_of(program, machine) == 3613 + reads + 3 * 29 - 3 * 10);
}

TEST_CASE("a segment of which the primitives leave no room for two commands in a node is refused, with what to do") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  figures(machine).memory_words = 31 + 32;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  --figures(machine).memory_words;
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the segment at 0,0 asks for 63 words of a node at once, and the nodes of four have 62; take a "
                       "machine file with more node.memory_words or subdivision.levels",
                       InputError);
}

TEST_CASE("what does not fit the display processor is read from the host, or tested twice: hand calculations") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  const std::uint64_t once = 2 * 37 + 3 * 41 + 2 * 61;
  // The model, and 5 words of records.
  figures(machine).display_memory_words = 32 + 5;
  CHECK(account_of(program, machine).stages.first_pruning == once);
  --figures(machine).display_memory_words;
  CHECK(account_of(program, machine).stages.first_pruning == 2 * once);
  CHECK(account_of(program, machine).first_halfspace_tests == 6);
  CHECK(clocks_of(program, machine) == 3613 + once);
  // Its planes, 24 bits of 504, are not there: each takes a word of the host's link, and is transformed.
  figures(machine).display_memory_words = 31;
  CHECK(account_of(program, machine).stages.first_pruning == 2 * (once + 3 * (5 + 3 + 43)));
  CHECK(account_of(program, machine).stages.transformation == 0);
  CHECK(account_of(program, machine).model_words == 32);
}

TEST_CASE("a model that does not fit the display processor without its planes is refused, with what to do") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  figures(machine).display_memory_words = 30;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  --figures(machine).display_memory_words;
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the model without its planes is 30 words, and the display processor of four has 29; take a "
                       "machine file with more display.memory_words, or give the model fewer faces",
                       InputError);
  figures(machine).display_memory_words = 36;
  figures(machine).memory_words = 34 + 32 - 1;
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "what the segment at 0,0 leaves of the model fits neither the memory of the nodes of four nor "
                       "that of its display processor; take a machine file with more node.memory_words, "
                       "display.memory_words or subdivision.levels",
                       InputError);
  program.display_model.clear();
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the Program has no display model, which four divides; compile the model for this machine",
                       InputError);
}

TEST_CASE("nodes stand still in turns of the screen, and nothing else does: hand calculations") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  // 32 bits of each node's in two turns; 20 turns a second, of 5 clocks every 50.
  machine.clock_hz = 1000;
  figures(machine).refresh = {.rate = 10, .bits = 16, .clocks = 5};
  const multi_processor::Refresh refresh(isa::frame_header(program), machine);
  CHECK(refresh.end_of(0, 50) == 50);
  CHECK(refresh.end_of(0, 51) == 56);
  CHECK(refresh.end_of(50, 1) == 56);
  CHECK(refresh.end_of(52, 1) == 56);
  CHECK(refresh.end_of(52, 0) == 52);
  CHECK(refresh.end_of(40, 60) == 110);
  const FrameAccount shown = account_of(program, machine);
  figures(machine).refresh.rate = 0;
  const FrameAccount account = account_of(program, machine);
  // Before are reception, transformation, the first pruning and broadcasts, to clock 817: turns at 850, 900, ... 1250.
  const multi_processor::StageClocks& stages = account.stages;
  CHECK(stages.reception + stages.transformation + stages.first_pruning + stages.broadcasting == 817);
  CHECK(shown.stages.second_pruning == 393 + 8 * 5);
  CHECK(shown.stages.sharing == stages.sharing);
  CHECK(shown.stages.broadcasting == stages.broadcasting);
  CHECK(shown.stages.rendering > stages.rendering);
}

TEST_CASE("what a screen leaves of the clocks is what is left when each turn is gone through") {
  CHECK(rc::check([] {
    Machine machine = random_machine();
    machine.clock_hz = *rc::gen::inRange<std::uint64_t>(50, 5000);
    figures(machine).refresh = {*rc::gen::inRange<std::uint32_t>(1, 20), 8, *rc::gen::inRange<std::uint32_t>(1, 9)};
    const isa::Program program = any_program(machine);
    const isa::FrameHeader header = isa::frame_header(program);
    const multi_processor::Refresh refresh(header, machine);
    if (refresh.turns_a_second() * figures(machine).refresh.clocks >= machine.clock_hz) return;
    const auto begin = *rc::gen::inRange<std::uint64_t>(0, 3000);
    const auto clocks = *rc::gen::inRange<std::uint64_t>(0, 300);
    std::uint64_t left = clocks;
    std::uint64_t now = begin;
    while (left > 0) {
      // Of the turns that have begun the last.
      const std::uint64_t turn = now * refresh.turns_a_second() / machine.clock_hz;
      std::uint64_t first = 0;
      while (first * refresh.turns_a_second() < turn * machine.clock_hz) ++first;
      if (turn == 0 || now >= first + figures(machine).refresh.clocks) --left;
      ++now;
    }
    RC_ASSERT(refresh.end_of(begin, clocks) == now);
  }));
}

TEST_CASE("a screen that takes all clocks of the nodes is refused") {
  Machine machine = machine_4x4();
  const isa::Program program = program_for(machine);
  machine.clock_hz = 1'000'000;
  figures(machine).refresh = {.rate = 100, .bits = 1, .clocks = 312};
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  ++figures(machine).refresh.clocks;
  CHECK_THROWS_WITH_AS(machines::check_runs_on(program, machine),
                       "the screen takes 3200 turns a second of 313 clocks each, and the memories of four have 1000000 "
                       "clocks a second: nothing could be drawn; give refresh.bits more",
                       InputError);
}

TEST_CASE("a frame that is longer than SystemC's time is refused") {
  Machine machine = machine_4x4();
  isa::Program program = program_for(machine);
  machine.clock_hz = 1;
  figures(machine).transform_clocks = 1'000'000;
  CHECK_THROWS_AS(machines::check_runs_on(program, machine), InputError);
  program.segments[0].division.steps = {{.cells = ~0ULL}};
  machine.clock_hz = 1'000'000'000;
  CHECK_THROWS_AS(machines::check_runs_on(program, machine), InputError);
}
