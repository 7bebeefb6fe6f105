// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/corner_divider.h"

#include "hw/division/encoding.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"
#include "hw/pixel_square/model_receiver.h"
#include "hw/pixel_square/store_sender.h"
#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

constexpr unsigned byte_bits = 8;
constexpr std::uint32_t link_width = 32;
constexpr std::uint32_t port_bits = 16;
constexpr std::uint64_t header_words = 4;

/// Record width of 16 bits: a primitive of these models (77 bits) takes 5 records, a half-space (5 or 6) one, a plane
/// (8) one.
constexpr std::uint32_t record_bits = 16;

pixel_square::Figures figures(std::uint32_t levels, std::uint32_t group_side, std::uint32_t list_entries) {
  return {.port_bits = port_bits,
          .divider = pixel_square::DividerKind::corners,
          .levels = levels,
          .group_side = group_side,
          .list_entries = list_entries,
          .model_bits = 100'000,
          .record_bits = record_bits,
          .halfspaces = 100,
          .nodes = 100,
          .store_words = 1000,
          .box_clocks = 2,
          .halfspace_clocks = 3,
          .cell_clocks = 5,
          .node_clocks = 7,
          .linear_clocks = 4};
}

/// A box is read in 5 clocks and held in 2; a half-space and its plane are read in 2 while the previous one is tested
/// in 3. Reading an entry of the list takes a clock more.
std::uint64_t clocks_of(const division::Counts& counts, bool from_list = false) {
  return (from_list ? 8 : 7) * counts.boxes + 3 * counts.halfspaces + (from_list ? 3 : 2) * counts.lists +
         5 * counts.cells + 7 * counts.nodes;
}

/// Half-spaces of a group are read and tested again, in 3 clocks, to compare them with leaders; the rest is listed.
std::uint64_t clocks_of_group(const division::Counts& counts, std::uint64_t listed) {
  return 7 * counts.boxes + 3 * counts.halfspaces + 2 * counts.lists + (5 + 3) * counts.cells + listed;
}

std::uint64_t tree_clocks(const division::DisplayModel& model) { return 7 * model.nodes.size(); }

/// Four squares of 8 x 8; the FIFO of the model has room for all of it.
struct Board {
  explicit Board(std::uint32_t levels, std::uint32_t group_side = 2, std::uint32_t list_entries = 100)
      : Board(make_machine(levels, group_side, list_entries)) {}

  explicit Board(const machines::Machine& described)
      : machine(described),
        bench(machine),
        receiver("receiver", machine),
        divider("divider", machine, receiver),
        sender("sender", machine) {
    receiver.clock(bench.clock);
    receiver.model(model);
    sender.clock(bench.clock);
    sender.links(links);
    sender.finished(finished);
    sender.clears(clears);
    sender.retirement(retirement);
    retirement.begin(listener);
  }

  /// Lets the divider finish: a thread that ended inside a square would leak the objects on its stack.
  ~Board() {
    for (int waits = 0; waits < 100 && divider.status().state != "done"; ++waits) bench.edges(1000);
  }

  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  static machines::Machine make_machine(std::uint32_t levels, std::uint32_t group_side, std::uint32_t list_entries) {
    machines::Machine machine = testing::square_machine(figures(levels, group_side, list_entries));
    machine.array = {8, 8, 16};
    machine.picture = {16, 16};
    return machine;
  }

  /// Writes the model to the FIFO and returns its number of words.
  std::uint64_t begin(const division::DisplayModel& display) {
    const division::Bits bits = division::encode(display);
    const std::vector<isa::LinkWord> words = division::to_link(bits, link_width);
    for (const isa::LinkWord& word : words) CHECK(model.nb_write(word));
    receiver.begin(division::to_link(bits, byte_bits).size());
    divider.begin({display.width, display.height}, squares, {0, 1, 2, 3});
    sender.begin(squares, std::vector<pixel_square::Store*>(squares.size(), &divider.store()));
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
  std::vector<isa::Region> squares{{0, 0, 8, 8}, {8, 0, 8, 8}, {0, 8, 8, 8}, {8, 8, 8, 8}};
  sc_core::sc_fifo<isa::LinkWord> model{"model", 1000};
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> links{
      "links", 1, [](const char* name, std::size_t) { return new sc_core::sc_fifo<isa::LinkWord>(name, 10'000); }};
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished{"finished", 1};
  sc_core::sc_fifo<PortWord> clears{"clears", 100};
  systemc::Retirement retirement{"retirement"};
  systemc::RunListener listener;
  pixel_square::ModelReceiver receiver;
  CornerDivider divider;
  pixel_square::StoreSender sender;
};

/// Returns the commands that hw/division computes for a square.
std::vector<isa::Command> expected_commands(const isa::Region& square, const division::SquareDivision& divided) {
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

/// Clocks that writing the commands takes.
std::uint64_t writing_clocks(const std::vector<isa::Command>& commands) {
  std::uint64_t clocks = words_of(commands);
  for (const isa::Command& command : commands) {
    const auto* instruction = std::get_if<isa::Instruction>(&command);
    const bool is_linear =
        instruction != nullptr && isa::has_operand(isa::operands_of(instruction->opcode), isa::OperandKind::linear);
    clocks += is_linear ? 4 : 0;
  }
  return clocks;
}

}  // namespace

TEST_CASE("the divider tests and writes squares in turn while complete ones leave") {
  const division::DisplayModel slab = testing::slab_with_hole();  // in the left half of the picture
  testing::ModelDivider judge(slab);
  const isa::Region left{0, 0, 8, 8};
  const division::SquareDivision drawn = judge.divide(left);
  REQUIRE((drawn.counts().boxes > 0 && drawn.counts().halfspaces > 0 && drawn.counts().nodes > 0));
  const division::SquareDivision empty = judge.divide({8, 0, 8, 8});
  REQUIRE(!drawn.instructions.empty());
  REQUIRE(empty.instructions.empty());
  const std::vector<isa::Command> expected = expected_commands(left, drawn);

  Board board(1);
  const std::uint64_t model_words = board.begin(slab);
  board.bench.edges(model_words - 1);
  CHECK(board.model.num_available() == 1);
  board.bench.edges(1);
  CHECK(board.model.num_available() == 0);
  const std::uint64_t first = tree_clocks(slab) + clocks_of(drawn.counts()) + writing_clocks(expected);
  board.bench.edges(first);
  CHECK(board.divider.store().fill() == words_of(expected));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  board.bench.edges(words_of(expected) - 1);
  CHECK(static_cast<std::uint64_t>(board.links[0].num_available()) == words_of(expected));
  // The empty second square is one word; its header is made a clock later.
  const std::uint64_t second = clocks_of(empty.counts()) + 1;
  REQUIRE(second < words_of(expected));
  CHECK(board.clears.num_available() == 0);
  board.bench.edges(header_words);
  CHECK(board.clears.num_available() == static_cast<int>(header_words));
  CHECK(board.commands() == expected);
  CHECK(testing::bits_of(testing::drained(board.clears), port_bits) ==
        testing::travelling({8, 0, 8, 8}, {}, 0, port_bits));
  CHECK(board.sender.squares_skipped() == 1);
  const std::uint64_t all = model_words + first + 1 + words_of(expected) - 1 + header_words;
  const std::uint64_t sent = words_of(expected) + header_words;
  CHECK(board.sender.account(all).of(SquareActivity::working) == sent);
  CHECK(board.sender.account(all).of(SquareActivity::waiting_for_divider) == all - sent);
}

TEST_CASE("a two-level divider tests a group first and then squares from the group's list") {
  const division::DisplayModel slab = testing::one_slab();
  testing::ModelDivider judge(slab);
  const division::Candidates list = judge.survivors({0, 0, 16, 16});
  const division::Counts group = judge.path.take_counts();
  const isa::Region left{0, 0, 8, 8};
  const division::SquareDivision drawn = judge.divide(left, list);
  const std::vector<isa::Command> expected = expected_commands(left, drawn);
  const std::uint64_t group_clocks = clocks_of_group(group, list.entry_count());
  REQUIRE(group_clocks > 0);

  Board board(2);
  board.bench.edges(board.begin(slab) + tree_clocks(slab) + group_clocks + clocks_of(drawn.counts(), true) +
                    writing_clocks(expected));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  board.bench.edges(words_of(expected) - 1);
  CHECK(board.commands() == expected);
}

TEST_CASE("an incomplete square leaves a full store while the divider waits") {
  const division::DisplayModel slab = testing::one_slab();
  testing::ModelDivider judge(slab);
  const isa::Region left{0, 0, 8, 8};
  const std::vector<isa::Command> expected = expected_commands(left, judge.divide(left));
  constexpr std::uint32_t room = 6;
  REQUIRE(words_of(expected) > 2 * room);
  machines::Machine machine = Board::make_machine(1, 2, 100);
  machines::kind_figures<pixel_square::Figures>(machine).store_words = room;

  Board board(machine);
  std::uint64_t edges = board.begin(slab);
  board.bench.edges(edges);
  const std::uint64_t most = edges + 10'000;
  for (; board.divider.store().fill() < room && edges < most; ++edges) {
    board.bench.edges(1);
    REQUIRE(board.links[0].num_available() == 0);
  }
  REQUIRE(edges < most);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  board.bench.edges(2 * writing_clocks(expected));
  CHECK(board.commands() == expected);
}

namespace {

/// A slab in the left half of the picture and another in the right half.
division::DisplayModel two_slabs() {
  division::DisplayModel model = testing::one_slab();
  division::Primitive right = model.primitives.front();
  right.box.pixels = {8, 0, 15, 15};
  model.primitives.push_back(right);
  model.nodes = {{}, {}, {2, division::Operator::unite}};
  return model;
}

/// Groups of one square. The square leaves after its tests: from the group's list if that has room, which excludes the
/// slab on the right; from the whole model if the list is an entry short.
void check_list_with(std::uint64_t entries_short) {
  const division::DisplayModel slab = two_slabs();
  testing::ModelDivider judge(slab);
  const isa::Region left{0, 0, 8, 8};
  const division::Candidates list = judge.survivors({0, 0, 8, 8});
  const division::Counts group = judge.path.take_counts();
  const division::SquareDivision drawn = judge.divide(left, list);
  const std::uint64_t from_list = clocks_of(drawn.counts(), true);
  const std::uint64_t from_all = clocks_of(judge.divide(left).counts());
  REQUIRE(list.entry_count() > 0);
  REQUIRE(from_list != from_all);
  const std::uint64_t room = list.entry_count() - entries_short;
  Board board(2, 1, static_cast<std::uint32_t>(room));
  board.bench.edges(board.begin(slab) + tree_clocks(slab) + clocks_of_group(group, room) +
                    (entries_short == 0 ? from_list : from_all) + writing_clocks(expected_commands(left, drawn)));
  CHECK(board.links[0].num_available() == 0);
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
}

}  // namespace

TEST_CASE("a divider uses a group's list that just fits its memory") { check_list_with(0); }

TEST_CASE("a divider does not use a group's list that is one entry too long") { check_list_with(1); }
