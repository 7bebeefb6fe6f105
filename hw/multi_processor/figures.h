#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::multi_processor {

/// Loop order of a node over its pixels of a subsegment and over the instructions of its list.
enum class RenderingOrder : std::uint8_t {
  segment,    ///< each instruction at all pixels
  scan_line,  ///< row of pixels by row: each instruction at all pixels of the row
  pixel,      ///< pixel by pixel: all instructions
};

inline constexpr auto rendering_order_names = std::to_array<std::string_view>({"segment", "scan-line", "pixel"});

/// Clocks of a node for an operation on one of its words.
struct OperationClocks {
  std::uint32_t read = 1;
  std::uint32_t write = 1;
  std::uint32_t add = 1;
  std::uint32_t compare = 1;
  std::uint32_t logic = 1;
  std::uint32_t multiply = 1;  ///< multiplication by one word
  std::uint32_t shift =
      0;  ///< shift by any number of bit positions below a word's width, in addition to shift_bit for each
  std::uint32_t shift_bit = 0;  ///< clocks per bit position of a shift

  constexpr bool operator==(const OperationClocks&) const = default;
};

/// Work that a node skips by branching at a pixel.
enum class Branches : std::uint8_t {
  none,    ///< nothing: an instruction costs the same at every pixel
  pixels,  ///< work without effect: the rest of the instruction if E is 0, and writes of values that are not kept
};

inline constexpr auto branches_names = std::to_array<std::string_view>({"none", "pixels"});

struct BranchFigures {
  Branches over = Branches::none;
  std::uint32_t taken = 0;   ///< clocks of a taken branch
  std::uint32_t passed = 0;  ///< clocks of a branch not taken

  constexpr bool operator==(const BranchFigures&) const = default;
};

/// How a node executes a list.
enum class NodeProgram : std::uint8_t {
  interpreted,  ///< an instruction is decoded each time it is executed
  native,       ///< the list is translated once to a chain of calls, which is then executed
};

inline constexpr auto node_program_names = std::to_array<std::string_view>({"interpreted", "native"});

/// Clocks of a native program, in addition to writing and reading its operands.
struct ChainFigures {
  NodeProgram program = NodeProgram::interpreted;
  std::uint32_t link = 0;  ///< clocks to append a call to the chain
  std::uint32_t call = 0;  ///< clocks to call and return

  constexpr bool operator==(const ChainFigures&) const = default;
};

/// Form of the lists that nodes send to each other.
enum class ListKind : std::uint8_t {
  instructions,  ///< instructions, encoded as on a link
  numbers,       ///< numbers of half-spaces, which every node holds
};

inline constexpr auto list_kind_names = std::to_array<std::string_view>({"instructions", "numbers"});

/// Clocks of the loops of a rendering.
struct LoopClocks {
  std::uint32_t pixel = 0;        ///< clocks per iteration of the loop over the pixels of a row
  std::uint32_t row = 0;          ///< clocks per iteration of the loop over rows
  std::uint32_t instruction = 0;  ///< clocks per iteration of the loop over instructions, to decode one, in addition to
                                  ///< reading its words

  constexpr bool operator==(const LoopClocks&) const = default;
};

/// Clocks of a processor that divides. The display processor uses only the first three.
struct TestClocks {
  std::uint32_t primitive = 0;    ///< clocks to compare the bounds of a primitive with a part of the picture
  std::uint32_t halfspace = 0;    ///< clocks to test a half-space at the corners of a part
  std::uint32_t cell = 0;         ///< clocks to compare a half-space of a side with the leaders of a cell
  std::uint32_t tree_node = 0;    ///< clocks to visit a node of the tree
  std::uint32_t instruction = 0;  ///< clocks to append an instruction to the list

  constexpr bool operator==(const TestClocks&) const = default;
};

/// Link from the host to the display processor's memory.
struct HostLink {
  std::uint32_t width = 1;        ///< bits of a word
  std::uint32_t word_clocks = 1;  ///< clocks between two words
  std::uint32_t latency = 0;      ///< clocks from the start of the frame to the first word

  constexpr bool operator==(const HostLink&) const = default;
};

/// Refresh of the screen from the picture in the nodes' memories. A turn occupies the memories of all nodes.
struct RefreshFigures {
  std::uint32_t rate = 0;    ///< pictures per second; 0: refresh takes no clocks
  std::uint32_t bits = 1;    ///< bits of each node's picture per turn
  std::uint32_t clocks = 1;  ///< clocks per turn

  constexpr bool operator==(const RefreshFigures&) const = default;
};

/// Value of Figures::field_clocks: a node holds each number of a record or an instruction in separate words on arrival.
inline constexpr std::uint32_t unpacked = 1'000'001;

/// A processor of the machine (hw/processors). It counts the machine's clocks.
struct ProcessorFigures {
  std::uint32_t type = 0;                ///< index into machines::processor_names
  std::uint32_t compiler_factor = 1000;  ///< clocks of a compiled program per thousand clocks of a hand-written one

  constexpr bool operator==(const ProcessorFigures&) const = default;
};

/// Parameters that only this kind of machine has. The nodes are machine.array: `width` columns, `height` rows.
struct Figures {
  ProcessorFigures node_processor{};
  ProcessorFigures display_processor{};
  std::uint32_t levels = 0;  ///< levels of binary subdivision of the picture into segments
  RenderingOrder order = RenderingOrder::segment;
  std::uint32_t word_bits = 16;    ///< word width of a node
  std::uint32_t memory_words = 0;  ///< memory of a node for the frame's tree, a segment's half-spaces, and lists
  OperationClocks operations;
  std::uint32_t field_clocks = unpacked;  ///< clocks to extract a number from packed bits, in addition to its shifts
                                          ///< and mask; or unpacked
  LoopClocks loop;
  TestClocks node_tests;
  TestClocks display_tests;
  HostLink host;
  std::uint32_t display_memory_words =
      0;                               ///< memory of the display processor for the model and the survivors of a segment
  std::uint32_t transform_clocks = 0;  ///< clocks of the display processor per plane of the model
  bool divides_ahead = false;          ///< the display processor divides the next segment while the nodes work
  RefreshFigures refresh{};
  BranchFigures branches{};
  ChainFigures chain{};
  ListKind lists = ListKind::instructions;
  std::uint32_t number_clocks = 0;   ///< clocks of a node to append the number of a half-space to a list
  std::uint32_t barrier_clocks = 0;  ///< clocks from the last node's arrival to the release of all nodes

  constexpr bool operator==(const Figures&) const = default;
};

}  // namespace csgsim::multi_processor
