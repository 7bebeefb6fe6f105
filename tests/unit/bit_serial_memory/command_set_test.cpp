#include "hw/bit_serial_memory/command_set.h"

#include <rapidcheck.h>

#include "hw/bit_serial_memory/gate_mapper.h"
#include "hw/bit_serial_memory/subarray.h"
#include "places.h"
#include "tests/support/error_of.h"
#include "tests/support/test.h"

using namespace csgsim;
using bit_serial_memory::CommandSet;
using bit_serial_memory::Gate;
using bit_serial_memory::GateCommand;
using bit_serial_memory::GateMapper;
using bit_serial_memory::Latch;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowOp;

namespace {

constexpr std::array latches{Latch::sense, Latch::carry, Latch::carry_2, Latch::held, Latch::enable, Latch::select};
constexpr std::size_t latch_count = bit_serial_memory::latch_names.size();

std::string command(const std::string& name, const std::string& table, unsigned clocks = 4) {
  return "[command." + name + "]\ntable = \"" + table + "\"\nclocks = " + std::to_string(clocks) +
         "\nenergy = 1\nprovenance = \"assumed\"\nsource = \"a test\"\n";
}

std::string set_of(const std::string& commands, unsigned temporaries = 2) {
  return "name = \"t\"\ndescription = \"a test\"\ntemporaries = " + std::to_string(temporaries) + "\n" + commands;
}

CommandSet read(const std::string& text) { return bit_serial_memory::read_command_set(text, "set.toml"); }

std::string refusal(const std::string& text) {
  return testing::error_of([&] { read(text); });
}

CommandSet example() {
  std::ifstream file(std::string(CSGSIM_SOURCE_DIR) + "/hw/bit_serial_memory/command_sets/nand.toml");
  return read({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
}

/// One word per latch.
using Words = std::array<std::uint64_t, latch_count>;

std::uint64_t& at(Words& words, Latch latch) { return words.at(static_cast<std::size_t>(latch)); }

/// Executes a gate by its definition.
void execute_gate(const RowCommand& gate, Words& words) {
  const std::uint64_t x = at(words, gate.x);
  const std::uint64_t y = at(words, gate.y);
  const std::uint64_t z = at(words, gate.z);
  const std::array<std::uint64_t, 9> results{0,        ~std::uint64_t{0}, x, ~x, x & y, x | y, x ^ y,
                                             ~(x ^ y), (x & y) | (~x & z)};
  at(words, gate.target) = results.at(static_cast<std::size_t>(gate.gate));
}

/// Executes a command of a set by its truth table, bit by bit.
void execute_own(const RowCommand& one, Words& words) {
  const std::array inputs{at(words, one.x), at(words, one.y), at(words, one.z)};
  std::uint64_t result = 0;
  for (unsigned bit = 0; bit < 64; ++bit) {
    unsigned index = 0;
    for (std::size_t i = 0; i < one.own->inputs; ++i)
      index = 2 * index + static_cast<unsigned>(inputs.at(i) >> bit & 1U);
    result |= std::uint64_t{one.own->table >> index & 1U} << bit;
  }
  at(words, one.target) = result;
}

Words random_words() {
  Words words{};
  for (std::uint64_t& word : words) word = *rc::gen::arbitrary<std::uint64_t>();
  return words;
}

/// Checks that the sequence of a gate computes it and changes no other latch except temporaries.
void check_gate(GateMapper& mapper, const RowCommand& gate) {
  Words expected = random_words();
  Words words = expected;
  execute_gate(gate, expected);
  const RowCommands sequence = mapper.expand({gate});
  for (const RowCommand& one : sequence) {
    RC_ASSERT(one.own != nullptr);
    execute_own(one, words);
  }
  for (const Latch latch : latches) RC_ASSERT(at(words, latch) == at(expected, latch));
}

void check_all_gates(GateMapper& mapper) {
  for (std::size_t number = 0; number < bit_serial_memory::gate_names.size(); ++number) {
    const auto pick = [] { return latches.at(*rc::gen::inRange<std::size_t>(0, latches.size())); };
    RowCommand gate{.op = RowOp::logic, .gate = static_cast<Gate>(number), .target = pick()};
    const unsigned operands = bit_serial_memory::operand_count(gate.gate);
    if (operands > 0) gate.x = pick();
    if (operands > 1) gate.y = pick();
    if (operands > 2) gate.z = pick();
    check_gate(mapper, gate);
  }
}

std::uint64_t clocks_of(GateMapper& mapper, Gate gate) {
  std::uint64_t clocks = 0;
  for (const bit_serial_memory::GateStep& step : mapper.sequence(gate, bit_serial_memory::no_aliases))
    clocks += mapper.set().commands.at(step.command).clocks;
  return clocks;
}

}  // namespace

TEST_CASE("the sequence of each gate computes its truth table with any operands") {
  const CommandSet nand = example();
  const CommandSet nor = read(set_of(command("NOR", "1000") + command("ZERO", "0")));
  const CommandSet sums = read(set_of(command("AND", "0001") + command("XOR", "0110") + command("ONE", "1"), 1));
  const CommandSet wide = read(set_of(command("SELECT", "00110101") + command("NOT", "10") + command("ONE", "1"), 1));
  for (const CommandSet* const set : {&nand, &nor, &sums, &wide}) {
    CAPTURE(set->commands.front().name);
    GateMapper mapper(*set);
    CHECK(rc::check("sequences of " + set->commands.front().name + " compute their gates",
                    [&] { check_all_gates(mapper); }));
  }
}

TEST_CASE("a gate gets the sequence of commands with the fewest clocks") {
  const CommandSet nand = example();
  GateMapper mapper(nand);
  CHECK(clocks_of(mapper, Gate::zero) == 4);
  CHECK(clocks_of(mapper, Gate::move) == 4);
  CHECK(clocks_of(mapper, Gate::invert) == 4);
  CHECK(clocks_of(mapper, Gate::conjunction) == 8);
  CHECK(clocks_of(mapper, Gate::disjunction) == 12);
  CHECK(clocks_of(mapper, Gate::unequal) == 16);
  CHECK(clocks_of(mapper, Gate::equal) == 20);
  CHECK(clocks_of(mapper, Gate::choose) == 16);
  // A slow XOR is worse than four fast NANDs, and a fast one better.
  for (const unsigned clocks : {17U, 15U}) {
    const CommandSet both = read(set_of(command("NAND", "1110") + command("XOR", "0110", clocks)));
    GateMapper of_both(both);
    CHECK(clocks_of(of_both, Gate::unequal) == std::min(clocks, 16U));
  }
}

TEST_CASE("a gate takes the file's sequence unless its target is an operand read later") {
  const CommandSet set = read(set_of(command("NAND", "1110")) +
                              "[sequence]\nMOVE = [\"T1 = NAND x x\", \"T2 = NAND T1 T1\", \"T1 = NAND T2 T2\", "
                              "\"target = NAND T1 T1\"]\n");
  GateMapper mapper(set);
  CHECK(mapper.sequence(Gate::move, bit_serial_memory::no_aliases).size() == 4);
  // x overwritten by the gate itself is still correct at the end.
  CHECK(mapper.expand({{.op = RowOp::logic, .gate = Gate::move}}).size() == 4);
  // Here the target is written before y is read: with y as the target the sequence is invalid, and another is searched.
  const CommandSet early = read(set_of(command("NAND", "1110")) +
                                "[sequence]\nAND = [\"target = NAND x x\", \"target = NAND x y\", "
                                "\"target = NAND target target\"]\n");
  GateMapper aliased(early);
  CHECK(aliased.sequence(Gate::conjunction, bit_serial_memory::no_aliases).size() == 3);
  CHECK(aliased.sequence(Gate::conjunction, {0, 1, 2, 1}).size() == 2);
}

TEST_CASE("expanding gates leaves reads and writes and leaf commands unchanged") {
  const CommandSet nand = example();
  GateMapper mapper(nand);
  const RowCommands rows{{.op = RowOp::read, .from = 3}, {.op = RowOp::write, .to = 4}, {.op = RowOp::leaf, .bit = 2}};
  CHECK(mapper.expand(rows) == rows);
}

TEST_CASE("the error for a gate without a sequence has the position of the commands") {
  const CommandSet set = read(set_of(command("AND", "0001")));
  GateMapper mapper(set);
  CHECK(
      testing::error_of([&] { mapper.sequence(Gate::invert, bit_serial_memory::no_aliases); }) ==
      "set.toml:4:1: no sequence of these commands was found for NOT; add commands or temporaries, or give a sequence "
      "in [sequence]");
}

TEST_CASE("the search for a gate that the commands cannot compute ends with an error") {
  // Monotone functions do not compute a choice; three operands and five latches have millions of them.
  const CommandSet set = read(set_of(command("AND", "0001") + command("OR", "0111"), 4));
  GateMapper mapper(set);
  const auto message = [&] { mapper.sequence(Gate::choose, bit_serial_memory::no_aliases); };
  CHECK(testing::error_of(message).starts_with("set.toml:4:1: no sequence of these commands was found for SEL"));
}

TEST_CASE("an invalid command set is rejected with the position and the mistake") {
  const std::string nand = command("NAND", "1110");
  const auto expects = [](const std::string& text, const std::string& message) {
    CAPTURE(text);
    CHECK(refusal(text) == message);
  };
  expects("name = \"t\"\n", "set.toml:1:1: key 'description' is missing; add it");
  expects("name = 1\n", "set.toml:1:8: 'name' is an integer; make it a string");
  expects("nam = 1\n", "set.toml:1:1: unknown key 'nam'; the nearest known is 'name'");
  expects(set_of(nand, 5), "set.toml:3:15: 'temporaries' is not a whole number from 0 to 4");
  expects(set_of(""), "set.toml:1:1: key 'command' is missing; add it");
  expects(set_of("[command]\n"), "set.toml:4:1: there are 0 commands; give 1 to 64");
  expects(set_of("[command]\nNAND = 1\n"), "set.toml:5:8: 'NAND' is an integer; make it a table");
  expects(set_of("[command.nand]\n"),
          "set.toml:4:10: a command's name is 1 to 16 capital letters, digits and _, beginning with a letter");
  expects(set_of(command("A", "012")), "set.toml:5:9: 'table' has other characters than 0 and 1; use only these");
  expects(set_of(command("A", "011")),
          "set.toml:5:9: 'table' has 3 bits; a function of 0 to 3 inputs has 1, 2, 4 or 8");
  expects(set_of(command("A", "0", 0)), "set.toml:6:10: 'clocks' is not a whole number from 1 to 65535");
  const std::string head = set_of(nand) + "[sequence]\n";
  expects(head + "XOOR = []\n", "set.toml:11:1: unknown key 'XOOR'; the nearest known is 'XOR'");
  expects(head + "XOR = 1\n", "set.toml:11:7: the sequence is not an array of up to 64 strings; write one");
  expects(head + "XOR = [1]\n", "set.toml:11:8: a command of a sequence is an integer; make it a string");
  expects(head + "XOR = [\"NAND\"]\n", "set.toml:11:8: 'NAND' is not a command; write it in the form T1 = COMMAND x y");
  expects(head + "NOT = [\"target = NAND x\"]\n",
          "set.toml:11:8: NAND has 2 inputs, but the sequence gives it 1; write 2");
  expects(
      head + "NOT = [\"target = NAND x y\"]\n",
      "set.toml:11:7: the sequence does not compute NOT of its operands, uses a latch before it is set, or changes an "
      "operand");
  CHECK(refusal(head + "NOT = [\"target = NAN x x\"]\n")
            .starts_with("set.toml:11:8: there is no command 'NAN'; did you "));
  CHECK(refusal(head + "NOT = [\"T3 = NAND x x\"]\n").starts_with("set.toml:11:8: there is no latch 'T3'"));
  CHECK(refusal("name = \n").starts_with("set.toml:1:8: "));
}
