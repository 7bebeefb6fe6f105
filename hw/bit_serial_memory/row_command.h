#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::bit_serial_memory {

/// Index of a row in its subarray.
using Row = std::uint16_t;

/// One of a row's word lines. Two rows have a negated word line, which connects the complement to the bit lines.
struct WordLine {
  Row row = 0;
  bool negated = false;

  constexpr bool operator==(const WordLine&) const = default;
};

/// Up to three word lines raised together.
struct WordLines {
  std::array<WordLine, 3> lines{};
  std::uint8_t count = 0;

  constexpr WordLines() = default;
  constexpr WordLines(WordLine one) : lines{one}, count(1) {}
  constexpr WordLines(Row one) : WordLines(WordLine{one, false}) {}
  constexpr WordLines(WordLine one, WordLine two) : lines{one, two}, count(2) {}
  constexpr WordLines(WordLine one, WordLine two, WordLine three) : lines{one, two, three}, count(3) {}

  [[nodiscard]] constexpr const WordLine* begin() const { return lines.data(); }
  [[nodiscard]] constexpr const WordLine* end() const { return lines.data() + count; }
  constexpr bool operator==(const WordLines&) const = default;
};

/// Latches at each sense amplifier. Rows are read into `sense` and written from it. Only designers' command sets have
/// temporaries.
enum class Latch : std::uint8_t {
  sense,
  carry,
  carry_2,
  held,
  enable,
  select,
  first_temporary,
  second_temporary,
  third_temporary,
  last_temporary,
};

inline constexpr auto latch_names =
    std::to_array<std::string_view>({"SA", "R1", "R2", "R3", "R4", "R5", "T1", "T2", "T3", "T4"});
inline constexpr std::size_t max_temporaries = 4;
inline constexpr std::size_t latch_count = latch_names.size();

constexpr std::string_view name_of(Latch latch) { return latch_names[static_cast<std::size_t>(latch)]; }

/// New value of a latch; x, y and z are latches.
enum class Gate : std::uint8_t {
  zero,         ///< 0
  one,          ///< 1
  move,         ///< x
  invert,       ///< not x
  conjunction,  ///< x and y
  disjunction,  ///< x or y
  unequal,      ///< x xor y
  equal,        ///< not (x xor y)
  choose,       ///< y where x is 1, otherwise z
};

inline constexpr auto gate_names =
    std::to_array<std::string_view>({"SET0", "SET1", "MOVE", "NOT", "AND", "OR", "XOR", "XNOR", "SEL"});

constexpr std::string_view name_of(Gate gate) { return gate_names[static_cast<std::size_t>(gate)]; }

/// Commands from the controller to all subarrays that hold pixels.
enum class RowOp : std::uint8_t {
  copy,      ///< activates `from`: one row, or the majority of three, which all three store; then `to` store that value
  activate,  ///< first half of `copy`
  latch,     ///< activates `from`, one row, into the enable latches
  read,      ///< `sense` := row `from`
  write,     ///< row `to` := `sense`
  logic,     ///< latch `target` := `gate` of x, y and z
  leaf,      ///< `sense` := bit `bit` of the expression, from the trees
  leaf_copy,  ///< `to` := bit `bit` of the expression, from the trees
  receive,    ///< row `to` := bit `bit` of the expression, from the host
  send,       ///< sends row `from` to the host
  wired_or,   ///< reports to the controller whether row `from`, or the enable latch, is 1 in any column
};

inline constexpr auto row_op_names = std::to_array<std::string_view>(
    {"AAP", "AP", "LATCH", "READ", "WRITE", "LOGIC", "LEAF", "LEAFAP", "RECEIVE", "SEND", "OR"});
inline constexpr std::size_t row_op_count = row_op_names.size();

constexpr std::string_view name_of(RowOp op) { return row_op_names[static_cast<std::size_t>(op)]; }

/// A gate command of a designer's set (hw/bit_serial_memory/command_set.h).
struct GateCommand {
  std::string name;
  std::uint32_t inputs = 0;  ///< number of latches that it reads: x, y, z in this order
  std::uint8_t table = 0;    ///< bit i: the result where the inputs form the number i, the first as its highest bit
  std::uint32_t clocks = 1;
  std::uint64_t energy_fj = 0;  ///< per column
  bool is_published = false;
  std::string source{};
};

/// A row command with its operands; operands that its op does not use are zero.
struct RowCommand {
  RowOp op = RowOp::activate;
  bool masked = false;  ///< copy, leaf_copy and write only: rows are written only where the latch `mask` is 1
  Latch mask = Latch::enable;
  Gate gate = Gate::zero;
  Latch target = Latch::sense;
  Latch x = Latch::sense;
  Latch y = Latch::sense;
  Latch z = Latch::sense;
  std::uint8_t bit = 0;  ///< bit of the expression
  WordLines from{};
  WordLines to{};
  const GateCommand* own = nullptr;  ///< logic only: the command that replaces `gate`

  constexpr bool operator==(const RowCommand&) const = default;
};

using RowCommands = std::vector<RowCommand>;

/// Number of activations that a subarray performs for the command.
constexpr unsigned activations(RowOp op) {
  switch (op) {
    case RowOp::copy: return 2;
    case RowOp::activate:
    case RowOp::latch:
    case RowOp::read:
    case RowOp::write:
    case RowOp::leaf_copy:
    case RowOp::receive:
    case RowOp::send: return 1;
    case RowOp::logic:
    case RowOp::leaf:
    case RowOp::wired_or: return 0;
  }
  return 0;
}

/// Whether the command starts with free sense amplifiers, so that a refresh may precede it: a refresh destroys their
/// content.
constexpr bool begins_closed(RowOp op) {
  switch (op) {
    case RowOp::copy:
    case RowOp::activate:
    case RowOp::latch:
    case RowOp::read:
    case RowOp::leaf_copy:
    case RowOp::receive:
    case RowOp::send: return true;
    case RowOp::write:
    case RowOp::logic:
    case RowOp::leaf:
    case RowOp::wired_or: return false;
  }
  return false;
}

/// The command as text without a line end, as in `AAP 17 -> 74 !78` or `LOGIC R2 = XOR SA R1`.
std::string text_of(const RowCommand& command);

}  // namespace csgsim::bit_serial_memory
