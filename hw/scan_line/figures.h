#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::scan_line {

/// How the value of an expression gets to the cells.
enum class Network : std::uint8_t {
  chain,  ///< from cell to cell, each of which adds
  trees,  ///< through the adders of a binary tree, to all cells at once
};

inline constexpr auto network_names = std::to_array<std::string_view>({"chain", "trees"});

/// What only this kind of machine has.
struct Figures {
  std::uint32_t words = 0;       ///< of a cell's memory
  std::uint32_t word_bits = 0;   ///< of each of them, and of the adder of the running sum
  std::uint32_t alu_bits = 0;    ///< that a cell's ALU goes through in a clock; 0 for any number
  std::uint32_t shift_bits = 0;  ///< by which a cell's shifter moves a word in a clock; 0 for no cost at all
  std::uint32_t ports = 0;       ///< words of a cell's memory read or written in a clock; 0 for any number
  Network network = Network::chain;
  std::uint32_t tree_bits = 1;           ///< of F that a tree brings in a clock, a word at most
  std::uint32_t chains = 1;              ///< lines worked on in parallel, each by a chain of its own
  std::uint32_t bucket_clocks = 0;       ///< of the host, to put a primitive into the bucket of its first line
  std::uint32_t active_clocks = 0;       ///< of the host, to look at a primitive of the active list, once a line
  std::uint32_t instruction_clocks = 0;  ///< of the host, to prepare an instruction of a line
  std::uint32_t refresh_hz = 0;          ///< fields a second that the screen shows
  bool interlaced = false;               ///< a field is every other line, even lines first

  constexpr bool operator==(const Figures&) const = default;
};

/// Clocks from the entry to a cell of such an array of so many: the place of the cell in the chain, or the levels of
/// the tree.
constexpr std::uint32_t clocks_to_cell(Network network, std::uint32_t cells, std::uint32_t cell) {
  if (network == Network::chain) return cell;
  std::uint32_t levels = 0;
  while ((std::uint64_t{1} << levels) < cells) ++levels;
  return levels;
}

}  // namespace csgsim::scan_line
