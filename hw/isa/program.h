// Programs: segments of instructions with a frame header.
// Used by hw, host/csg, host/emit, host/view and sim.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/base/indirect.h"
#include "hw/isa/instruction.h"

namespace csgsim::isa {

struct SegmentFacts;    // hw/isa/host_counts.h
struct DivisionCounts;  // hw/isa/host_counts.h
struct Preparation;     // hw/isa/host_counts.h
struct Facts;           // hw/isa/facts.h

}  // namespace csgsim::isa

namespace csgsim {

extern template class Indirect<isa::SegmentFacts>;
extern template class Indirect<isa::DivisionCounts>;
extern template class Indirect<isa::Preparation>;
extern template class Indirect<isa::Facts>;

}  // namespace csgsim

namespace csgsim::isa {

/// A rectangle of pixels of the picture; row 0 is at the top.
struct Region {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  /// Whether the pixel of the picture is inside.
  [[nodiscard]] constexpr bool holds(std::uint32_t column, std::uint32_t row) const {
    return column >= x && column - x < width && row >= y && row - y < height;
  }
  constexpr bool operator==(const Region&) const = default;
};

/// The instructions broadcast to one region. Linear expressions count x and y from the region's top left pixel. A
/// region without instructions shows the background, and its pixel processors do nothing.
struct Segment {
  Region region;
  std::vector<Instruction> instructions;
  Indirect<SegmentFacts> facts{};
  Indirect<DivisionCounts> division{};  ///< all 0 without a display model
  Indirect<Preparation> preparation{};  ///< work of the host for these instructions

  bool operator==(const Segment&) const = default;
};

/// Size of an array, or of the picture that a Program draws, and memory per pixel.
struct ArrayShape {
  std::uint32_t width = 0;        ///< pixels
  std::uint32_t height = 0;       ///< pixels
  std::uint32_t memory_bits = 0;  ///< bits per pixel

  constexpr bool operator==(const ArrayShape&) const = default;
};

/// The first and last row of the picture with instructions for one piece.
struct RowExtent {
  std::uint16_t first = 0;
  std::uint16_t last = 0;

  constexpr bool operator==(const RowExtent&) const = default;
};

/// The machine that a Program was compiled for. All members are empty if it is not recorded.
struct MachineRecord {
  std::string name;                  ///< name of the machine, followed by its changed parameters
  std::string kind;                  ///< empty: the kind of the built-in machine with that name
  std::vector<std::string> figures;  ///< KEY=VALUE; parameters not listed have the built-in machine's values

  bool operator==(const MachineRecord&) const = default;
};

/// A frame as sent from host to machine, with the counts and facts that the host adds.
struct Program {
  MachineRecord machine{};
  ArrayShape shape;              ///< the whole picture
  Field colour{};                ///< displayed field of pixel memory; width 0 if nothing is displayed
  std::uint32_t background = 0;  ///< colour where nothing is seen, in the format of the colour field
  std::vector<Segment> segments;
  /// One extent per piece, in any order, for a host that keeps an active list of pieces per line and sorts them into
  /// buckets. Empty for other machines.
  std::vector<RowExtent> extents{};
  /// Display model as a bit stream, which replaces the segments on the link of a machine that divides the model itself;
  /// the first bit is the lowest of the first byte. Empty for other machines. The segments are then the expected result
  /// of the division.
  std::vector<std::uint8_t> display_model{};
  Indirect<Preparation> preparation{};  ///< work of the host for the frame, before the first segment
  Indirect<Facts> facts{};
  Indirect<Preparation> model_preparation{};  ///< work of the host for the model, the same for every camera

  bool operator==(const Program&) const = default;
};

/// The frame data that a machine receives in addition to the segments.
struct FrameHeader {
  ArrayShape shape;              ///< the whole picture
  Field colour;                  ///< displayed field of pixel memory; width 0 if nothing is displayed
  std::uint32_t background = 0;  ///< colour of a region without instructions

  constexpr bool operator==(const FrameHeader&) const = default;
};

FrameHeader frame_header(const Program& program);

/// The number of instructions in all segments.
std::size_t total_instructions(const Program& program);

/// Throws InputError unless the instruction can run on an array with `memory_bits` bits per pixel: the opcode is in the
/// table; fields lie inside the memory, have widths that the opcode permits, and are disjoint (single bits may
/// coincide); linear width and shift are in range and wide enough for the compared field; a constant is no wider than
/// its target; a count is not 0; unused operands are zero.
void validate(const Instruction& instruction, std::uint32_t memory_bits);

/// Throws InputError with the number of the segment and instruction unless every part of the Program is valid.
void validate(const Program& program);

}  // namespace csgsim::isa
