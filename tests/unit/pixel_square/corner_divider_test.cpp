// SystemC elaborates once a process, so each case here runs in a process of its own, as ctest does it.

#include "hw/pixel_square/corner_divider.h"

#include <doctest/doctest.h>

#include <variant>
#include <vector>

#include "hw/division/encoding.h"
#include "hw/isa/wire.h"
#include "tests/unit/division/hand_models.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using pixel_square::CornerDivider;
using pixel_square::PortWord;
using pixel_square::SquareActivity;
using testing::Bench;

namespace {

constexpr unsigned byte_bits = 8;
constexpr std::uint32_t link_width = 32;
constexpr std::uint32_t port_bits = 16;
constexpr std::uint64_t header_words = 4;

pixel_square::Figures figures(std::uint32_t levels, std::uint32_t group_side, std::uint32_t list_entries) {
  return {.port_bits = port_bits,
          .divider = pixel_square::DividerKind::corners,
          .levels = levels,
          .group_side = group_side,
          .list_entries = list_entries,
          .model_bits = 100'000,
          .box_clocks = 2,
          .halfspace_clocks = 3,
          .cell_clocks = 5,
          .node_clocks = 7};
}

std::uint64_t clocks_of(const division::Counts& counts) {
  return 2 * counts.boxes + 3 * counts.halfspaces + 5 * counts.cells + 7 * counts.nodes;
}

/// Four squares of 8 x 8; the FIFO of the model has room for all of it.
struct Board {
  explicit Board(std::uint32_t levels, std::uint32_t group_side = 2, std::uint32_t list_entries = 100)
      : machine(machine_of(levels, group_side, list_entries)), bench(machine), divider("divider", machine) {
    divider.clock(bench.clock);
    divider.model(model);
    divider.links(links);
    divider.finished(finished);
    divider.clears(clears);
    divider.retirement(retirement);
    retirement.begin(listener);
  }

  static machines::Machine machine_of(std::uint32_t levels, std::uint32_t group_side, std::uint32_t list_entries) {
    machines::Machine machine = testing::square_machine(figures(levels, group_side, list_entries));
    machine.array = {8, 8, 16};
    machine.picture = {16, 16};
    return machine;
  }

  /// Puts the model into the FIFO, and returns how many words it is.
  std::uint64_t begin(const division::DisplayModel& display) {
    const division::Bits bits = division::encode(display);
    const std::vector<isa::LinkWord> words = division::to_link(bits, link_width);
    for (const isa::LinkWord& word : words) CHECK(model.nb_write(word));
    divider.begin({display.width, display.height}, division::to_link(bits, byte_bits).size());
    return words.size();
  }

  [[nodiscard]] std::vector<isa::Command> commands() {
    isa::WireDecoder decoder(link_width);
    std::vector<isa::Command> all;
    for (const isa::LinkWord& word : testing::drained(links[0]))
      if (auto command = decoder.take(word)) all.push_back(*command);
    return all;
  }

  machines::Machine machine;
  Bench bench;
  sc_core::sc_fifo<isa::LinkWord> model{"model", 1000};
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> links{
      "links", 1, [](const char* name, std::size_t) { return new sc_core::sc_fifo<isa::LinkWord>(name, 10'000); }};
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished{"finished", 1};
  sc_core::sc_fifo<PortWord> clears{"clears", 100};
  systemc::Retirement retirement{"retirement"};
  systemc::RunListener listener;
  CornerDivider divider;
};

/// What hw/division makes of a square, as commands.
std::vector<isa::Command> expected_commands(const isa::Region& square, const division::Divided& divided) {
  std::vector<isa::Command> all{isa::SegmentStart{square}};
  for (const isa::Instruction& one : divided.instructions) all.push_back(isa::as_received(one));
  all.push_back(isa::SegmentEnd{});
  return all;
}

std::uint64_t words_of(const std::vector<isa::Command>& commands) {
  std::uint64_t words = 0;
  for (const isa::Command& command : commands) words += isa::wire_words(command, link_width);
  return words;
}

}  // namespace

TEST_CASE("the divider takes a word a clock, tests a square, sends it a word a clock, and goes on with the next") {
  const division::DisplayModel slab = testing::slab_with_hole();  // in the left half of the picture
  const division::Divider judge(slab);
  const isa::Region left{0, 0, 8, 8};
  const division::Divided drawn = judge.divide(left);
  REQUIRE((drawn.counts.boxes > 0 && drawn.counts.halfspaces > 0 && drawn.counts.nodes > 0));
  const division::Divided empty = judge.divide({8, 0, 8, 8});
  REQUIRE(!drawn.instructions.empty());
  REQUIRE(empty.instructions.empty());
  const std::vector<isa::Command> expected = expected_commands(left, drawn);

  Board board(1);
  const std::uint64_t model_words = board.begin(slab);
  board.bench.edges(model_words - 1);
  CHECK(board.model.num_available() == 1);
  board.bench.edges(1);
  CHECK(board.model.num_available() == 0);
  board.bench.edges(clocks_of(drawn.counts));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  board.bench.edges(words_of(expected) - 1);
  CHECK(static_cast<std::uint64_t>(board.links[0].num_available()) == words_of(expected));
  board.bench.edges(clocks_of(empty.counts));
  CHECK(board.clears.num_available() == 0);
  board.bench.edges(header_words);
  CHECK(board.clears.num_available() == static_cast<int>(header_words));
  CHECK(board.commands() == expected);
  CHECK(testing::bits_of(testing::drained(board.clears), port_bits) ==
        testing::travelling({8, 0, 8, 8}, {}, 0, port_bits));
  CHECK(board.divider.squares_skipped() == 1);
  const std::uint64_t all =
      model_words + clocks_of(drawn.counts) + words_of(expected) + clocks_of(empty.counts) + header_words;
  CHECK(board.divider.account(all).of(SquareActivity::working) == all);
}

TEST_CASE("with two levels a group is tested before its first square, and the squares from what it leaves") {
  const division::DisplayModel slab = testing::one_slab();
  const division::Divider judge(slab);
  division::Counts group;
  const division::Candidates list = judge.survivors({0, 0, 16, 16}, group);
  const isa::Region left{0, 0, 8, 8};
  const division::Divided drawn = judge.divide(left, list);
  REQUIRE(clocks_of(group) > 0);

  Board board(2);
  board.bench.edges(board.begin(slab) + clocks_of(group) + clocks_of(drawn.counts));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  const std::vector<isa::Command> expected = expected_commands(left, drawn);
  board.bench.edges(words_of(expected) - 1);
  CHECK(board.commands() == expected);
}

namespace {

/// A slab in the left half of the picture, and another in the right.
division::DisplayModel two_slabs() {
  division::DisplayModel model = testing::one_slab();
  division::Primitive right = model.primitives.front();
  right.box.pixels = {8, 0, 15, 15};
  model.primitives.push_back(right);
  model.nodes = {{}, {}, {2, division::Operator::unite}};
  return model;
}

/// With groups of one square. It leaves after its tests: from the group's list where that has room, which is without
/// the slab on the right; from the whole model where it is an entry short.
void check_list_with(std::uint64_t entries_short) {
  const division::DisplayModel slab = two_slabs();
  const division::Divider judge(slab);
  const isa::Region left{0, 0, 8, 8};
  division::Counts group;
  const division::Candidates list = judge.survivors({0, 0, 8, 8}, group);
  const std::uint64_t from_list = clocks_of(judge.divide(left, list).counts);
  const std::uint64_t from_all = clocks_of(judge.divide(left).counts);
  REQUIRE(list.entries() > 0);
  REQUIRE(from_list != from_all);
  Board board(2, 1, static_cast<std::uint32_t>(list.entries() - entries_short));
  board.bench.edges(board.begin(slab) + clocks_of(group) + (entries_short == 0 ? from_list : from_all));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
}

}  // namespace

TEST_CASE("a group's list that just has room is used") { check_list_with(0); }

TEST_CASE("a group's list that is an entry too long is not used") { check_list_with(1); }
