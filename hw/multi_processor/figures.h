#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::multi_processor {

/// How a node goes over its pixels of a subsegment and over the instructions of its list.
enum class RenderingOrder : std::uint8_t {
  segment,    ///< each instruction at all pixels
  scan_line,  ///< each row of pixels: each instruction at all pixels of the row
  pixel,      ///< each pixel: all instructions
};

inline constexpr auto rendering_order_names = std::to_array<std::string_view>({"segment", "scan-line", "pixel"});

/// Clocks that a node takes for an operation on one of its words.
struct OperationClocks {
  std::uint32_t read = 1;
  std::uint32_t write = 1;
  std::uint32_t add = 1;
  std::uint32_t compare = 1;
  std::uint32_t logic = 1;
  std::uint32_t multiply = 1;   ///< with one word
  std::uint32_t shift = 0;      ///< by any number of places below a word's, besides what each of them takes
  std::uint32_t shift_bit = 0;  ///< a place of a shift

  constexpr bool operator==(const OperationClocks&) const = default;
};

/// What a node goes over at a pixel.
enum class Branches : std::uint8_t {
  none,    ///< nothing: an instruction costs the same at every pixel
  pixels,  ///< what an instruction has no effect on: the rest of it where E is 0, the writing of what is not kept
};

inline constexpr auto branches_names = std::to_array<std::string_view>({"none", "pixels"});

struct BranchFigures {
  Branches over = Branches::none;
  std::uint32_t taken = 0;   ///< clocks
  std::uint32_t passed = 0;  ///< clocks of one that is not taken

  constexpr bool operator==(const BranchFigures&) const = default;
};

/// How a node carries out a list.
enum class NodeProgram : std::uint8_t {
  interpreted,  ///< an instruction is decoded whenever it comes to it
  native,       ///< the list is made into a chain of calls once, which is gone through
};

inline constexpr auto node_program_names = std::to_array<std::string_view>({"interpreted", "native"});

/// Clocks of a native program, besides the numbers that it writes and reads.
struct ChainFigures {
  NodeProgram program = NodeProgram::interpreted;
  std::uint32_t link = 0;  ///< to put a call into the chain
  std::uint32_t call = 0;  ///< and to return from it

  constexpr bool operator==(const ChainFigures&) const = default;
};

/// What the nodes tell each other of a list.
enum class ListKind : std::uint8_t {
  instructions,  ///< as a link carries them
  numbers,       ///< of half-spaces, which every node has
};

inline constexpr auto list_kind_names = std::to_array<std::string_view>({"instructions", "numbers"});

/// Clocks of the loops around them.
struct LoopClocks {
  std::uint32_t pixel = 0;        ///< a pass of the loop over the pixels of a row
  std::uint32_t row = 0;          ///< a pass of the loop over rows
  std::uint32_t instruction = 0;  ///< a pass of the loop over instructions, to decode one; its words are read besides

  constexpr bool operator==(const LoopClocks&) const = default;
};

/// Clocks of a processor that divides. The display processor does nothing but the first three.
struct TestClocks {
  std::uint32_t primitive = 0;    ///< to hold the bounds of a primitive against a part of the picture
  std::uint32_t halfspace = 0;    ///< to hold a half-space against the corners of one
  std::uint32_t cell = 0;         ///< to hold a half-space of a side against the leaders of a cell
  std::uint32_t tree_node = 0;    ///< to look at a node of the tree
  std::uint32_t instruction = 0;  ///< to put an instruction into the list

  constexpr bool operator==(const TestClocks&) const = default;
};

/// How the model comes from the host into the display processor's memory.
struct HostLink {
  std::uint32_t width = 1;        ///< bits of a word
  std::uint32_t word_clocks = 1;  ///< from one word to the next
  std::uint32_t latency = 0;      ///< clocks from the frame's beginning to the first word

  constexpr bool operator==(const HostLink&) const = default;
};

/// How the screen reads what the nodes have of the picture. In a turn it takes the memories of all.
struct RefreshFigures {
  std::uint32_t rate = 0;    ///< pictures a second; 0: they are shown for nothing
  std::uint32_t bits = 1;    ///< of each node's in a turn
  std::uint32_t clocks = 1;  ///< of a turn

  constexpr bool operator==(const RefreshFigures&) const = default;
};

/// Of a node that has every number of a record or an instruction in words of its own, as soon as they come.
inline constexpr std::uint32_t unpacked = 1'000'001;

/// What only this kind of machine has. The nodes are machine.array: `width` columns, `height` rows.
struct Figures {
  std::uint32_t levels = 0;  ///< of binary subdivision of the picture, into segments
  RenderingOrder order = RenderingOrder::segment;
  std::uint32_t word_bits = 16;    ///< of a node
  std::uint32_t memory_words = 0;  ///< of a node, for the frame's tree, a segment's half-spaces and lists
  OperationClocks operations;
  std::uint32_t field_clocks = unpacked;  ///< to come to a number among bits, besides its shifts and mask; or unpacked
  LoopClocks loop;
  TestClocks node_tests;
  TestClocks display_tests;
  HostLink host;
  std::uint32_t display_memory_words = 0;  ///< of the display processor, for the model and what a segment leaves of it
  std::uint32_t transform_clocks = 0;      ///< of the display processor, a plane of the model
  bool divides_ahead = false;              ///< the display processor divides the next segment while the nodes work
  RefreshFigures refresh{};
  BranchFigures branches{};
  ChainFigures chain{};
  ListKind lists = ListKind::instructions;
  std::uint32_t number_clocks = 0;   ///< of a node, to put the number of a half-space into a list
  std::uint32_t barrier_clocks = 0;  ///< from the last node's arrival until all go on

  constexpr bool operator==(const Figures&) const = default;
};

}  // namespace csgsim::multi_processor
