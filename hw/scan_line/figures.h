#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::scan_line {

/// Network that computes the value of an expression for the cells.
enum class Network : std::uint8_t {
  chain,  ///< the value passes from cell to cell, and each cell adds its difference
  trees,  ///< a binary tree of adders computes the values of all cells at once
};

inline constexpr auto network_names = std::to_array<std::string_view>({"chain", "trees"});

/// Parameters that only this kind of machine has.
struct Figures {
  std::uint32_t words = 0;       ///< words of a cell's memory
  std::uint32_t word_bits = 0;   ///< bits of each word, and of the adder of the running sum
  std::uint32_t alu_bits = 0;    ///< bits that a cell's ALU processes per clock; 0 for any number
  std::uint32_t shift_bits = 0;  ///< bits by which a cell's shifter moves a word per clock; 0 if shifts take no clocks
  std::uint32_t ports = 0;       ///< words of a cell's memory read or written per clock; 0 for any number
  Network network = Network::chain;
  std::uint32_t tree_bits = 1;           ///< bits of F that a tree delivers per clock, at most a word
  std::uint32_t chains = 1;              ///< chains that draw lines in parallel
  std::uint32_t bucket_clocks = 0;       ///< clocks of the host to sort a primitive into the bucket of its first line
  std::uint32_t active_clocks = 0;       ///< clocks of the host to visit a primitive of the active list, once per line
  std::uint32_t instruction_clocks = 0;  ///< clocks of the host to prepare an instruction of a line
  std::uint32_t refresh_hz = 0;          ///< fields per second shown by the screen
  bool interlaced = false;               ///< whether a field consists of every other line, even lines first

  constexpr bool operator==(const Figures&) const = default;
};

/// Clocks from the entry to a cell of an array of `cells` cells: in a chain the index of the cell, in a tree the number
/// of levels.
constexpr std::uint32_t clocks_to_cell(Network network, std::uint32_t cells, std::uint32_t cell) {
  if (network == Network::chain) return cell;
  std::uint32_t levels = 0;
  while ((std::uint64_t{1} << levels) < cells) ++levels;
  return levels;
}

}  // namespace csgsim::scan_line
