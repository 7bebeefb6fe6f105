#include "hw/scan_line/chain.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/plain_cells.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::Beat;
using scan_line::CellShape;
using scan_line::Chain;
using scan_line::Departure;
using scan_line::Packet;
using scan_line::PacketKind;
using scan_line::RefreshPixel;
using systemc::Keep;

namespace {

constexpr Beat nothing{};
constexpr Field colour{0, 8};

Packet packet(const Instruction& instruction, const CellShape& shape, bool begins_line = false) {
  Packet packet = scan_line::instruction_packet(instruction, shape);
  packet.begins_line = begins_line;
  packet.keep = Keep::all;
  return packet;
}

/// Sends the packet through the entry and calls seen() after each clock.
template <class Machine, class Seen>
void send(Machine& chain, const Packet& packet, const Seen& seen) {
  for (std::uint32_t beat = 0; beat < packet.beats; ++beat) {
    chain.step({&packet, beat});
    seen();
  }
}

template <class Machine>
void send(Machine& chain, const Packet& packet) {
  send(chain, packet, [] {});
}

Packet mark() {
  Packet packet = scan_line::mark_packet(colour, {.word_bits = 8, .ports = 1});
  packet.keep = Keep::all;
  return packet;
}

void require_same(const scan_line::Snapshot& actual, const reference::ReferenceArray& expected, isa::ArrayShape shape) {
  for (std::uint32_t x = 0; x < shape.width; ++x) {
    RC_ASSERT((actual.enable[x / 64] >> x % 64 & 1U) == (expected.is_enabled(x, 0) ? 1U : 0U));
    for (std::uint32_t bit = 0; bit < shape.memory_bits; ++bit) {
      const Field field{static_cast<std::uint16_t>(bit), 1};
      RC_ASSERT(actual.read(x, field) == expected.read(field, x, 0));
    }
  }
}

}  // namespace

TEST_CASE("a two-word packet acts in cell x a clock after cell x - 1 and leaves at the end") {
  constexpr CellShape shape{.word_bits = 4, .ports = 1};
  Chain chain(9, 8, shape);
  chain.begin(5);
  const Instruction instruction{.opcode = Opcode::edge_negative, .linear = {.a = 1, .c = 3, .width = 8}};
  const Packet sent = packet(instruction, shape);
  REQUIRE(sent.beats == 2);
  std::vector<PacketKind> left;
  std::uint64_t busy_cells = 0;
  for (std::uint32_t clock = 0; clock < 8; ++clock) {
    chain.step(clock < sent.beats ? Beat{&sent, clock} : nothing);
    left.push_back(chain.departure().kind);
    busy_cells += chain.departure().busy_cells;
  }
  std::vector<PacketKind> expected(8, PacketKind::none);
  expected[1 + 4] = PacketKind::instruction;
  CHECK(left == expected);
  CHECK(busy_cells == 2 * 5);
}

TEST_CASE("after random packets of any length every cell equals the reference") {
  CHECK(rc::check([] {
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 70U), 1, *rc::gen::inRange(1U, 100U)};
    const CellShape cell{.word_bits = *rc::gen::inRange(1U, 65U),
                         .ports = *rc::gen::inRange(0U, 6U),
                         .alu_bits = *rc::gen::inRange(0U, 40U),
                         .shift_bits = *rc::gen::inRange(0U, 40U)};
    const auto instructions = *rc::gen::resize(
        20, rc::gen::container<std::vector<Instruction>>(test::arbitrary_instruction(shape, shape.memory_bits, 0)));
    Chain chain(shape.width + 3, shape.memory_bits, cell);
    chain.begin(shape.width);
    reference::ReferenceArray judge(shape);
    std::size_t left = 0;
    const auto look = [&] {
      const Departure& departure = chain.departure();
      if (departure.kind == PacketKind::none) return;
      RC_ASSERT(departure.enabled_pixels == judge.enabled_pixels());
      judge.execute(instructions[left++]);
      require_same(*departure.snapshot, judge, shape);
    };
    for (const Instruction& instruction : instructions) send(chain, packet(instruction, cell), look);
    for (std::uint32_t i = 0; i < shape.width; ++i) {
      chain.step(nothing);
      look();
    }
    RC_ASSERT(left == instructions.size());
  }));
}

TEST_CASE("the first packet of a line finds memory and enable clear") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(2, 8, shape);
  chain.begin(2);
  const Instruction set{.opcode = Opcode::set_constant, .fields = {colour}, .constant = 200};
  for (const Instruction& one : {Instruction{.opcode = Opcode::enable_all}, set}) send(chain, packet(one, shape));
  send(chain, packet({.opcode = Opcode::enable_invert}, shape));
  CHECK(chain.read(0, colour) == 200);
  send(chain, packet(set, shape, true));
  CHECK(chain.read(0, colour) == 0);
  CHECK_FALSE(chain.enabled(0));
}

TEST_CASE("pixel x reaches the refresh port x clocks after the shift chain takes the line") {
  constexpr std::uint32_t pixels = 3;
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(5, 8, shape);
  chain.begin(pixels);
  const Instruction ramp{.opcode = Opcode::load_linear, .fields = {colour}, .linear = {.a = 5, .c = 7, .width = 10}};
  send(chain, packet({.opcode = Opcode::enable_all}, shape));
  send(chain, packet(ramp, shape));
  send(chain, mark());
  std::vector<RefreshPixel> seen;  // the pixels seen from the clock after the mark's entry on
  for (std::uint32_t i = 0; i < 8; ++i) {
    seen.push_back(chain.refresh());
    chain.step(nothing);
  }
  const std::vector<RefreshPixel> expected{{}, {}, {}, {true, 7}, {true, 12}, {true, 17}, {}, {}};
  CHECK(seen == expected);
}

TEST_CASE("a mark sent before the previous line has left the shift chain is an error") {
  constexpr std::uint32_t pixels = 4;
  for (std::uint32_t apart = 1; apart <= pixels + 1; ++apart) {
    CAPTURE(apart);
    Chain chain(6, 8, {.word_bits = 8, .ports = 1});
    chain.begin(pixels);
    std::uint32_t shown = 0;
    const Packet sent = mark();
    const auto step = [&](const Beat& beat) {
      chain.step(beat);
      shown += chain.refresh().valid ? 1U : 0U;
    };
    step({&sent, 0});
    for (std::uint32_t i = 1; i < apart; ++i) step(nothing);
    if (apart < pixels) {
      CHECK_THROWS_AS(step({&sent, 0}), std::logic_error);
      continue;
    }
    CHECK_NOTHROW(step({&sent, 0}));
    for (std::uint32_t i = 0; i < 4 * pixels; ++i) step(nothing);
    CHECK(shown == 2 * pixels);
  }
}

TEST_CASE("a clear packet clears a cell with its last beat") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(1, 8, shape);
  chain.begin(1);
  send(chain, packet({.opcode = Opcode::enable_all}, shape));
  send(chain, packet({.opcode = Opcode::set_constant, .fields = {colour}, .constant = 9}, shape));
  const Packet clear = scan_line::clear_packet(2);
  chain.step({&clear, 0});
  CHECK(chain.read(0, colour) == 9);
  chain.step({&clear, 1});
  CHECK(chain.read(0, colour) == 0);
  CHECK_FALSE(chain.enabled(0));
}

TEST_CASE("a packet that is not followed by its own next beat is an error") {
  constexpr CellShape shape{.word_bits = 4, .ports = 1};
  const Packet sent = packet({.opcode = Opcode::edge_negative, .linear = {.a = 1, .c = 3, .width = 8}}, shape);
  Chain chain(2, 8, shape);
  chain.begin(2);
  CHECK_THROWS_AS(chain.step({&sent, 1}), std::logic_error);
  chain.step({&sent, 0});
  CHECK_THROWS_AS(chain.step(nothing), std::logic_error);
}

namespace {

/// Random packets of a line with gaps between them.
std::vector<Packet> random_packets(isa::ArrayShape shape, const CellShape& cell) {
  std::vector<Packet> packets{scan_line::clear_packet(*rc::gen::inRange(1U, 4U))};
  isa::Linear squares;
  for (const Instruction& instruction : *rc::gen::resize(
           20,
           rc::gen::container<std::vector<Instruction>>(test::arbitrary_instruction(shape, shape.memory_bits, 0, 2)))) {
    packets.push_back(scan_line::instruction_packet(instruction, cell, squares));
    packets.back().begins_line = *rc::gen::inRange(0, 10) == 0;
    squares = instruction.opcode == Opcode::squares ? instruction.linear : isa::Linear{};
  }
  return packets;
}

/// Compares all visible state of the cell and of the beat that enters it.
void require_same(const Chain& chain, const test::PlainChain& judge, std::uint32_t x, isa::ArrayShape shape,
                  const CellShape& cell) {
  RC_ASSERT(chain.enabled(x) == judge.cells().enabled(x));
  RC_ASSERT(chain.sum(x) == judge.cells().sum(x));
  for (std::uint32_t bit = 0; bit < shape.memory_bits; ++bit) {
    const Field field{static_cast<std::uint16_t>(bit), 1};
    RC_ASSERT(chain.read(x, field) == judge.cells().read(x, field));
  }
  if (chain.clocks_to(x) == 0) return;
  const Beat actual = chain.beat_in(x);
  const test::PlainBeat* const expected = judge.beat_in(x);
  RC_ASSERT((actual.packet == nullptr) == (expected == nullptr));
  if (expected == nullptr) return;
  RC_ASSERT(*actual.packet == static_cast<const Packet&>(*expected));
  RC_ASSERT(actual.number == expected->number);
  if (cell.tree_bits == 0 && expected->brings_f())
    RC_ASSERT(arriving_words(actual, x, cell) == (scan_line::BeatWords{expected->f, expected->a, expected->aa}));
}

}  // namespace

TEST_CASE("a cell's state read at any clock equals that of an eager simulation") {
  CHECK(rc::check([] {
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 40U), 1, *rc::gen::inRange(1U, 100U)};
    const CellShape cell{.word_bits = *rc::gen::inRange(1U, 65U),
                         .ports = *rc::gen::inRange(0U, 6U),
                         .alu_bits = *rc::gen::inRange(0U, 40U),
                         .shift_bits = *rc::gen::inRange(0U, 40U),
                         .tree_bits = *rc::gen::element(0U, 0U, 1U, 7U, 64U)};
    Chain chain(shape.width, shape.memory_bits, cell);
    chain.begin(shape.width);
    test::PlainChain judge(shape.width, shape.memory_bits, cell);
    const auto step = [&](const Beat& beat) {
      chain.step(beat);
      judge.step(beat);
      if (*rc::gen::inRange(0, 4) != 0) return;
      require_same(chain, judge, *rc::gen::inRange(0U, shape.width), shape, cell);
    };
    for (const Packet& sent : random_packets(shape, cell)) {
      for (std::uint32_t beat = 0; beat < sent.beats; ++beat) step({&sent, beat});
      for (auto breaks = *rc::gen::inRange(0, 3); breaks > 0; --breaks) step(nothing);
    }
    for (std::uint32_t i = 0; i < shape.width; ++i) step(nothing);
    for (std::uint32_t x = 0; x < shape.width; ++x) require_same(chain, judge, x, shape, cell);
  }));
}
