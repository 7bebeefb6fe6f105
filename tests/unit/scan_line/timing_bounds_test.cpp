#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "hw/scan_line/timing.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Instruction;
using isa::Opcode;
using scan_line::Figures;

namespace {

machines::Machine random_machine() {
  const auto pick = [](std::uint32_t least, std::uint32_t most) { return *rc::gen::inRange(least, most + 1); };
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.name = "test";
  const std::uint32_t width = pick(1, 20);
  const Figures figures{.words = pick(1, 64),
                        .word_bits = pick(1, 62),
                        .alu_bits = pick(0, 64),
                        .shift_bits = pick(0, 64),
                        .ports = pick(0, 4),
                        .network = pick(0, 1) == 1 ? scan_line::Network::trees : scan_line::Network::chain,
                        .tree_bits = pick(1, 64),
                        .chains = pick(1, 4),
                        .bucket_clocks = pick(0, 9),
                        .active_clocks = pick(0, 9),
                        .instruction_clocks = pick(0, 3),
                        .refresh_hz = 60,
                        .interlaced = pick(0, 1) == 1};
  machine.own = figures;
  machine.array = {width + pick(0, 3), 1, figures.words * figures.word_bits};
  machine.picture = {width, pick(1, 9)};
  machine.clock_hz = 20'000;
  machine.clear_clocks = pick(0, 9);
  machine.link = {.width = pick(1, 256), .word_clocks = pick(1, 4), .fifo_depth = pick(1, 20), .latency = pick(0, 20)};
  return machine;
}

/// A cell's accesses to the words of its memory: each word of each operand once.
struct MemoryWords {
  std::uint64_t read = 0;
  std::uint64_t written = 0;
};

MemoryWords memory_words(const Instruction& instruction, std::uint32_t word_bits) {
  MemoryWords words;
  for (std::size_t i = 0; i < isa::max_operands; ++i) {
    std::set<unsigned> touched;
    const isa::Field field = instruction.fields.at(i);
    for (unsigned bit = field.base; bit < field.end(); ++bit) touched.insert(bit / word_bits);
    const bool target = isa::info(instruction.opcode).operands.at(i) == isa::OperandKind::target;
    const bool is_read = !target || instruction.opcode == Opcode::keep_max || instruction.opcode == Opcode::keep_min ||
                         instruction.opcode == Opcode::xor_constant || instruction.opcode == Opcode::add;
    if (is_read) words.read += touched.size();
    if (target) words.written += touched.size();
  }
  return words;
}

/// Busy clocks of each part, without waits.
struct Busy {
  std::uint64_t host = 0;
  std::vector<std::uint64_t> links;
  std::vector<std::uint64_t> entries;
  std::vector<std::uint64_t> refreshes;
  std::uint64_t commands = 0;
  std::uint64_t words = 0;
  std::uint64_t work = 0;  ///< upper bound for shifters and ALUs
};

/// Lower bound of an instruction's clocks in each cell.
std::uint64_t least_clocks(const Instruction& instruction, const Figures& figures) {
  std::uint64_t bits = std::max<std::uint64_t>(instruction.linear.width, 1);
  for (const isa::Field& field : instruction.fields) bits = std::max<std::uint64_t>(bits, field.width);
  std::uint64_t words = (bits + figures.word_bits - 1) / figures.word_bits;
  if (figures.network == scan_line::Network::trees && instruction.opcode != Opcode::squares)
    words = std::max<std::uint64_t>(words, (instruction.linear.width + figures.tree_bits - 1) / figures.tree_bits);
  if (figures.ports == 0) return words;
  const MemoryWords memory = memory_words(instruction, figures.word_bits);
  return std::max(words, (memory.read + memory.written + figures.ports - 1) / figures.ports);
}

/// Upper bound for shifter and ALU: two operands, with the words at their ends, bit by bit; the sum bit by bit, or one
/// trial per bit of a root.
std::uint64_t most_work(const Instruction& instruction, const Figures& figures) {
  std::uint64_t bits = instruction.linear.width;
  for (const isa::Field& field : instruction.fields) bits = std::max<std::uint64_t>(bits, field.width);
  const std::uint64_t words = bits / figures.word_bits + 2;
  return 2 * words * figures.word_bits + (instruction.opcode == Opcode::root ? bits * bits : bits);
}

Busy least(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  Busy busy;
  busy.links.resize(figures.chains);
  busy.entries.resize(figures.chains);
  busy.refreshes.resize(figures.chains);
  for (std::size_t line = 0; line < program.segments.size(); ++line) {
    const isa::Segment& segment = program.segments[line];
    const std::size_t chain = line % figures.chains;
    const auto send = [&](const isa::Command& command) {
      const std::uint64_t words = (isa::wire_bits(command) + machine.link.width - 1) / machine.link.width;
      busy.links[chain] += words * machine.link.word_clocks;
      busy.words += words;
      ++busy.commands;
    };
    busy.host += 1 + segment.instructions.size() * figures.instruction_clocks;
    send(isa::SegmentStart{segment.region});
    busy.entries[chain] += machine.clear_clocks + 1;
    for (const Instruction& instruction : segment.instructions) {
      send(instruction);
      busy.entries[chain] += least_clocks(instruction, figures);
      busy.work += most_work(instruction, figures);
    }
    send(isa::SegmentEnd{});
    busy.refreshes[chain] += program.shape.width;
  }
  return busy;
}

std::uint64_t sum(const std::vector<std::uint64_t>& all) {
  return std::accumulate(all.begin(), all.end(), std::uint64_t{0});
}

std::uint64_t clocks_on(const isa::Program& program, const machines::Machine& machine) {
  return scan_line::time_lines(program, machine).clocks;
}

}  // namespace

TEST_CASE("a frame takes at least its busiest part's work and at most the sum of all work") {
  CHECK(rc::check([] {
    const machines::Machine machine = random_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 12);
    const Figures& figures = machines::kind_figures<Figures>(machine);
    const std::uint64_t clocks = clocks_on(program, machine);
    const Busy busy = least(program, machine);
    const std::uint64_t width = program.shape.width;
    // The way to the last cell, then one pixel per clock: a tree of up to 32 leaves has 5 levels.
    const bool has_trees = figures.network == scan_line::Network::trees;
    const std::uint64_t way = has_trees ? width + 1 : 2 * width;
    RC_ASSERT(clocks >= busy.host + way);
    for (std::size_t chain = 0; chain < figures.chains; ++chain) {
      RC_ASSERT(clocks >= busy.links[chain] + (busy.links[chain] > 0 ? machine.link.latency + way : 0));
      RC_ASSERT(clocks >= busy.entries[chain] + (busy.entries[chain] > 0 ? way : 0));
      RC_ASSERT(clocks >= busy.refreshes[chain] + (busy.refreshes[chain] > 0 ? width : 0));
    }
    const std::uint64_t primitives = program.extents.size();
    const std::uint64_t lines = program.segments.size();
    const std::uint64_t host =
        busy.host + primitives * figures.bucket_clocks + lines * primitives * figures.active_clocks;
    // Sequential reads and writes, each in whole clocks, take at most one clock more than both together; a FIFO of one
    // place costs each word a clock there and one in the receiver; taking a command costs a clock; a mark's colour is
    // read.
    const std::uint64_t handling = 3 * busy.commands + 2 * busy.words + 32 * lines + 10;
    RC_ASSERT(clocks <= host + sum(busy.links) + machine.link.latency * figures.chains + sum(busy.entries) + busy.work +
                            handling + (lines + 2) * width + (has_trees ? 6 : 0));
  }));
}

TEST_CASE("the frame interval is at most the frame's clocks and at least its busiest part's") {
  CHECK(rc::check([] {
    const machines::Machine machine = random_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 12);
    const scan_line::LineTiming timing = scan_line::time_lines(program, machine);
    const Busy busy = least(program, machine);
    RC_ASSERT(timing.interval_clocks <= timing.clocks);
    RC_ASSERT(timing.interval_clocks >= busy.host);
    for (const auto* const parts : {&busy.links, &busy.entries, &busy.refreshes})
      for (const std::uint64_t clocks : *parts) RC_ASSERT(timing.interval_clocks >= clocks);
  }));
}

TEST_CASE("every part of a scan-line array accounts for every clock of the frame") {
  CHECK(rc::check([] {
    const machines::Machine machine = random_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 12);
    const machines::FrameTiming timing = scan_line::kind.time(program, machine, {});
    RC_ASSERT(timing.account.parts.size() == 4U);
    for (const machines::PartAccount& part : timing.account.parts) {
      std::uint64_t clocks = 0;
      for (const machines::ActivityClocks& activity : part.clocks) clocks += activity.clocks;
      RC_ASSERT(clocks == timing.clocks);
    }
  }));
}

TEST_CASE("better links and more ports and wider ALUs and faster hosts never add clocks") {
  CHECK(rc::check([] {
    const machines::Machine machine = random_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 12);
    const std::uint64_t clocks = clocks_on(program, machine);
    const auto improve = [&](const auto& change) {
      machines::Machine better = machine;
      change(better, machines::kind_figures<Figures>(better));
      RC_ASSERT(clocks_on(program, better) <= clocks);
    };
    const auto more = [](std::uint32_t least, std::uint32_t most) { return *rc::gen::inRange(least, most + 1); };
    const auto fewer = [](std::uint32_t least, std::uint32_t now) { return *rc::gen::inRange(least, now + 1); };
    improve([&](machines::Machine& better, Figures&) { better.link.width = more(better.link.width, 256); });
    improve([&](machines::Machine& better, Figures&) { better.link.word_clocks = fewer(1, better.link.word_clocks); });
    improve([&](machines::Machine& better, Figures&) { better.link.fifo_depth = more(better.link.fifo_depth, 40); });
    improve([&](machines::Machine& better, Figures&) { better.link.latency = fewer(0, better.link.latency); });
    improve([&](machines::Machine& better, Figures&) { better.clear_clocks = fewer(0, better.clear_clocks); });
    improve([&](machines::Machine&, Figures& figures) {
      figures.ports = figures.ports == 0 ? 0 : more(figures.ports, 70);
    });
    improve([&](machines::Machine&, Figures& figures) { figures.ports = 0; });
    improve([&](machines::Machine&, Figures& figures) {
      figures.alu_bits = figures.alu_bits == 0 ? 0 : more(figures.alu_bits, 64);
    });
    improve([&](machines::Machine&, Figures& figures) { figures.alu_bits = 0; });
    improve([&](machines::Machine&, Figures& figures) {
      figures.shift_bits = figures.shift_bits == 0 ? 0 : more(figures.shift_bits, 64);
    });
    improve([&](machines::Machine&, Figures& figures) { figures.shift_bits = 0; });
    improve([&](machines::Machine&, Figures& figures) { figures.bucket_clocks = fewer(0, figures.bucket_clocks); });
    improve([&](machines::Machine&, Figures& figures) { figures.active_clocks = fewer(0, figures.active_clocks); });
    improve([&](machines::Machine&, Figures& figures) {
      figures.instruction_clocks = fewer(0, figures.instruction_clocks);
    });
  }));
}
