#include "hw/bit_serial_memory/row_text.h"

#include <rapidcheck.h>

#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// An independent simulator that reads only the text.
class Replay {
 public:
  Replay(std::uint32_t width, std::uint32_t height) : width_(width), columns_(std::size_t{width} * height) {}

  void line(const std::string& text) {
    std::istringstream in(text.substr(0, text.find('#')));
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (words.empty()) return;
    if (words[0] == "rows") return name(words);
    if (words[0] == "AAP" || words[0] == "AP" || words[0] == "READ" || words[0] == "SEND") return open(words);
    if (words[0] == "WRITE") return write(words, 1);
    REQUIRE(words[0] == "LOGIC");
    logic(words);
  }

  [[nodiscard]] bool memory(unsigned bit, std::size_t column) { return row(bit)[column]; }
  [[nodiscard]] bool enabled(std::size_t column) { return row(first_.at("enable"))[column]; }

 private:
  using Bits = std::vector<bool>;

  void name(const std::vector<std::string>& words) {
    const unsigned first = number(words[2]);
    first_[words[1]] = first;
    for (std::size_t column = 0; column < columns_; ++column) {
      if (words[1] == "one") row(first)[column] = true;
      for (unsigned bit = 0; bit < number(words[3]); ++bit) {
        if (words[1] == "x") row(first + bit)[column] = (column % width_ >> bit & 1U) != 0;
        if (words[1] == "y") row(first + bit)[column] = (column / width_ >> bit & 1U) != 0;
      }
    }
  }

  void open(const std::vector<std::string>& words) {
    const auto arrow = std::ranges::find(words, "->");
    const std::vector<std::string> from(words.begin() + 1, arrow);
    Bits& sensed = latches_["SA"];
    sensed.resize(columns_);
    for (std::size_t column = 0; column < columns_; ++column) {
      std::size_t ones = 0;
      for (const std::string& one : from) ones += seen(one, column) ? 1U : 0U;
      sensed[column] = 2 * ones > from.size();
    }
    if (from.size() > 1) write(words, 1);
    if (arrow != words.end()) write(words, arrow - words.begin() + 1);
  }

  /// Writes the sense amplifiers to the rows from word `first` up to the arrow.
  void write(const std::vector<std::string>& words, std::ptrdiff_t first) {
    for (std::size_t i = static_cast<std::size_t>(first); i < words.size() && words[i] != "->"; ++i) {
      for (std::size_t column = 0; column < columns_; ++column)
        row(number(words[i]))[column] = latches_["SA"][column] != (words[i][0] == '!');
    }
  }

  void logic(const std::vector<std::string>& words) {
    Bits result(columns_);
    const auto latch = [&](std::size_t word, std::size_t column) {
      Bits& bits = latches_[words[word]];
      bits.resize(columns_);
      return static_cast<bool>(bits[column]);
    };
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::string& gate = words[3];
      const bool x = words.size() > 4 && latch(4, column);
      const bool y = words.size() > 5 && latch(5, column);
      const bool z = words.size() > 6 && latch(6, column);
      result[column] = gate == "SET1" || (gate == "MOVE" && x) || (gate == "NOT" && !x) || (gate == "AND" && x && y) ||
                       (gate == "OR" && (x || y)) || (gate == "XOR" && x != y) || (gate == "XNOR" && x == y) ||
                       (gate == "SEL" && (x ? y : z));
    }
    latches_[words[1]] = result;
  }

  static unsigned number(const std::string& word) {
    return static_cast<unsigned>(std::stoul(word.substr(word[0] == '!' ? 1 : 0)));
  }
  bool seen(const std::string& word, std::size_t column) { return row(number(word))[column] != (word[0] == '!'); }
  Bits& row(unsigned number) {
    Bits& bits = rows_[number];
    bits.resize(columns_);
    return bits;
  }

  const std::size_t width_;
  const std::size_t columns_;
  std::map<std::string, unsigned> first_;
  std::map<unsigned, Bits> rows_;
  std::map<std::string, Bits> latches_;
};

void check_replay(const std::string& name) {
  machines::Machine machine = kinds::load(name + "+array.memory_bits=32");
  machines::set_picture_size(machine, {7, 6});
  isa::Program program = *test::arbitrary_program_in_parts(machine, 12, 1);
  test::erase_queries(program.segments.front().instructions);
  std::ostringstream text;
  bit_serial_memory::print_row_commands(text, program, machine);
  Replay replay(7, 6);
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line);) replay.line(line);
  reference::ReferenceArray judge(isa::ArrayShape{7, 6, 32});
  for (const isa::Instruction& instruction : program.segments.front().instructions) judge.execute(instruction);
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 7; ++x) {
      RC_ASSERT(replay.enabled(y * 7 + x) == judge.is_enabled(x, y));
      for (unsigned bit = 0; bit < 32; ++bit)
        RC_ASSERT(replay.memory(bit, y * 7 + x) == (judge.read({static_cast<std::uint16_t>(bit), 1}, x, y) != 0));
    }
  }
}

}  // namespace

TEST_CASE("replaying the text of row commands yields the Program's pixel memory") {
  for (const std::string name : {"ambit-ddr4", "simdram-ddr4", "digital-bit-serial-ddr4"}) {
    CAPTURE(name);
    CHECK(rc::check("the replay matches the reference on " + name, [&] { check_replay(name); }));
  }
}

TEST_CASE("the text of row commands has a heading for each instruction") {
  machines::Machine machine = kinds::load("digital-bit-serial-ddr4+array.memory_bits=2");
  machines::set_picture_size(machine, {9, 7});
  isa::Program program;
  program.shape = {9, 7, 2};
  program.colour = {1, 1};
  const isa::Linear minus_one{.a = 0, .b = 0, .c = -1, .width = 4, .shift = 0};
  program.segments.push_back({.region = {0, 0, 9, 7},
                              .instructions = {{.opcode = isa::Opcode::enable_all},
                                               {.opcode = isa::Opcode::edge_negative, .linear = minus_one}}});
  program.segments.push_back({.region = {0, 0, 9, 7}, .instructions = {{.opcode = isa::Opcode::enable_all}}});
  // Rows after two rows of memory: 0, 1, E, select, carry, 4 scratch, T0 to T3, two duals, 62 of sums, 40 spare; x up
  // to 8 has four bits and y up to 6 has three.
  const std::string rows =
      "rows memory 0 2\nrows zero 2 1\nrows one 3 1\nrows enable 4 1\nrows select 5 1\nrows carry 6 1\n"
      "rows scratch 7 4\nrows triple 11 4\nrows dual 15 2\nrows sum 17 62\nrows spare 79 40\nrows x 119 4\n"
      "rows y 123 3\n";
  const std::string clear =
      "LOGIC SA = SET0\nWRITE 0\nLOGIC SA = SET0\nWRITE 1\nLOGIC R4 = SET0\nLOGIC SA = MOVE R4\nWRITE 4\n";
  const std::string enable_all = " enable_all\nLOGIC R4 = SET1\nLOGIC SA = MOVE R4\nWRITE 4\n";
  // The sign of -1 is 1.
  const std::string edge =
      "# i1 edge_negative a=0 b=0 c=-1 width=4\nREAD 4\nLOGIC R4 = MOVE SA\nLOGIC SA = SET1\n"
      "LOGIC R4 = AND R4 SA\nLOGIC SA = MOVE R4\nWRITE 4\n";
  const std::string expected = "# " + machine.name + ": 9 x 7 pixels, pixel y * 9 + x in column y * 9 + x\n" + rows +
                               "# segment 0: all pixel memory becomes 0\n" + clear + "# i0" + enable_all + edge +
                               "# segment 1: all pixel memory becomes 0\n" + clear + "# i2" + enable_all;
  std::ostringstream text;
  bit_serial_memory::print_row_commands(text, program, machine);
  CHECK(text.str() == expected + "# the picture goes to the host\nSEND 1\n");
  program.colour = {};
  std::ostringstream without;
  bit_serial_memory::print_row_commands(without, program, machine);
  CHECK(without.str() == expected);
}

TEST_CASE("the text of each row command contains exactly its operands") {
  using bit_serial_memory::Gate;
  using bit_serial_memory::Latch;
  using bit_serial_memory::RowCommand;
  using bit_serial_memory::RowOp;
  using bit_serial_memory::WordLine;
  using bit_serial_memory::WordLines;
  const WordLine dual{78, true};
  const WordLines three(WordLine{1, false}, WordLine{2, false}, dual);
  const auto gate = [](Gate function) {
    return text_of(RowCommand{.op = RowOp::logic,
                              .gate = function,
                              .target = Latch::carry_2,
                              .x = Latch::sense,
                              .y = Latch::carry,
                              .z = Latch::held});
  };
  const WordLines row(WordLine{17, false});
  CHECK(text_of(RowCommand{.op = RowOp::copy, .from = row, .to = {WordLine{74, false}, dual}}) == "AAP 17 -> 74 !78");
  CHECK(text_of(RowCommand{.op = RowOp::copy, .masked = true, .mask = Latch::select, .from = three, .to = row}) ==
        "AAP 1 2 !78 -> 17 where R5");
  CHECK(text_of(RowCommand{.op = RowOp::activate, .from = three}) == "AP 1 2 !78");
  CHECK(text_of(RowCommand{.op = RowOp::latch, .from = row}) == "LATCH 17");
  CHECK(text_of(RowCommand{.op = RowOp::read, .from = row}) == "READ 17");
  CHECK(text_of(RowCommand{.op = RowOp::write, .to = row}) == "WRITE 17");
  CHECK(text_of(RowCommand{.op = RowOp::write, .masked = true, .to = row}) == "WRITE 17 where R4");
  CHECK(text_of(RowCommand{.op = RowOp::leaf, .bit = 9}) == "LEAF 9");
  CHECK(text_of(RowCommand{.op = RowOp::leaf_copy, .masked = true, .bit = 9, .to = row}) == "LEAFAP 9 -> 17 where R4");
  CHECK(text_of(RowCommand{.op = RowOp::receive, .bit = 9, .to = row}) == "RECEIVE 9 -> 17");
  CHECK(text_of(RowCommand{.op = RowOp::send, .from = row}) == "SEND 17");
  CHECK(text_of(RowCommand{.op = RowOp::wired_or}) == "OR");
  CHECK(text_of(RowCommand{}) == "AP");
  CHECK(gate(Gate::zero) == "LOGIC R2 = SET0");
  CHECK(gate(Gate::one) == "LOGIC R2 = SET1");
  CHECK(gate(Gate::move) == "LOGIC R2 = MOVE SA");
  CHECK(gate(Gate::invert) == "LOGIC R2 = NOT SA");
  CHECK(gate(Gate::conjunction) == "LOGIC R2 = AND SA R1");
  CHECK(gate(Gate::disjunction) == "LOGIC R2 = OR SA R1");
  CHECK(gate(Gate::unequal) == "LOGIC R2 = XOR SA R1");
  CHECK(gate(Gate::equal) == "LOGIC R2 = XNOR SA R1");
  CHECK(gate(Gate::choose) == "LOGIC R2 = SEL SA R1 R3");
}
