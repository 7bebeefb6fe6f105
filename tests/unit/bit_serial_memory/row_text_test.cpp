#include "hw/bit_serial_memory/row_text.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"

using namespace csgsim;

namespace {

/// Another simulator: it knows the text alone.
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

  /// What is at the sense amplifiers goes to the rows from that word on, up to the arrow.
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
  test::erase_questions(program.segments.front().instructions);
  std::ostringstream text;
  bit_serial_memory::print_row_commands(text, program, machine);
  Replay replay(7, 6);
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line);) replay.line(line);
  reference::ReferenceArray judge(isa::ArrayShape{7, 6, 32});
  for (const isa::Instruction& instruction : program.segments.front().instructions) judge.execute(instruction);
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 7; ++x) {
      RC_ASSERT(replay.enabled(y * 7 + x) == judge.enabled(x, y));
      for (unsigned bit = 0; bit < 32; ++bit)
        RC_ASSERT(replay.memory(bit, y * 7 + x) == (judge.read({static_cast<std::uint16_t>(bit), 1}, x, y) != 0));
    }
  }
}

}  // namespace

TEST_CASE("who replays the text of row commands has the pixel memory that the Program leaves") {
  for (const std::string name : {"ambit-ddr4", "simdram-ddr4", "digital-bit-serial-ddr4"}) {
    CAPTURE(name);
    CHECK(rc::check("of " + name, [&] { check_replay(name); }));
  }
}
