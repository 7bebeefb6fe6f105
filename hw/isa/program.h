#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/base/indirect.h"
#include "hw/isa/instruction.h"

namespace csgsim::isa {

struct SegmentFacts;    // hw/isa/host_counts.h
struct DivisionCounts;  // the same
struct Preparation;     // the same
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

  /// Whether that pixel of the picture is in it.
  [[nodiscard]] constexpr bool holds(std::uint32_t column, std::uint32_t row) const {
    return column >= x && column - x < width && row >= y && row - y < height;
  }
  constexpr bool operator==(const Region&) const = default;
};

/// The instructions broadcast to one region. Linear expressions count x and y from the region's top left pixel. Without
/// instructions the region shows the background, and no pixel processor works on it.
struct Segment {
  Region region;
  std::vector<Instruction> instructions;
  Indirect<SegmentFacts> facts{};
  Indirect<DivisionCounts> division{};  ///< all 0 without a display model
  Indirect<Preparation> preparation{};  ///< of the host, for these instructions

  bool operator==(const Segment&) const = default;
};

/// Pixels, of an array or of the picture that a Program draws, and the memory of each.
struct ArrayShape {
  std::uint32_t width = 0;        ///< pixels
  std::uint32_t height = 0;       ///< pixels
  std::uint32_t memory_bits = 0;  ///< a pixel

  constexpr bool operator==(const ArrayShape&) const = default;
};

/// The rows of the picture from the first to the last that have instructions for a primitive's piece.
struct RowExtent {
  std::uint16_t first = 0;
  std::uint16_t last = 0;

  constexpr bool operator==(const RowExtent&) const = default;
};

/// The machine that a Program was compiled for. All empty: it does not say.
struct MachineRecord {
  std::string name;                  ///< as machines are named, with changed figures behind it
  std::string kind;                  ///< empty: the one of the machine of that name that comes with csgsim
  std::vector<std::string> figures;  ///< KEY=VALUE; those that are left out are as that machine has them

  bool operator==(const MachineRecord&) const = default;
};

/// All that crosses from host to machine, with the counts and facts that the host adds.
struct Program {
  MachineRecord machine{};
  ArrayShape shape;              ///< the whole picture
  Field colour{};                ///< of pixel memory, which is shown; of width 0 where nothing is
  std::uint32_t background = 0;  ///< colour where nothing is seen, as the colour field holds it
  std::vector<Segment> segments;
  /// What a host that keeps a list of the pieces on a line sorts into buckets, a piece each, in no order that matters;
  /// none for other machines.
  std::vector<RowExtent> extents{};
  /// What a machine that divides the model itself is sent in place of the segments, the first bit in the lowest of the
  /// first byte; none for other machines. The segments are what it has to make of that.
  std::vector<std::uint8_t> display_model{};
  Indirect<Preparation> preparation{};  ///< of the host, for the frame, before the first segment
  Indirect<Facts> facts{};

  bool operator==(const Program&) const = default;
};

/// What a machine is told of a frame besides its segments.
struct FrameHeader {
  ArrayShape shape;              ///< the whole picture
  Field colour;                  ///< of pixel memory, which is shown; of width 0 where nothing is
  std::uint32_t background = 0;  ///< colour of a region without instructions

  constexpr bool operator==(const FrameHeader&) const = default;
};

FrameHeader frame_header(const Program& program);

/// How many all its segments have.
std::size_t instructions_in(const Program& program);

/// Throws InputError unless the instruction can run on an array of that memory: opcode in the table, fields inside the
/// memory and of the widths the opcode asks for, fields of one instruction disjoint (single bits may coincide), linear
/// width and shift in range and wide enough for the field it meets, constant no wider than its target, count not 0,
/// unused operands zero.
void validate(const Instruction& instruction, std::uint32_t memory_bits);

/// Throws InputError unless every part of the Program is sound; says which segment and instruction is not.
void validate(const Program& program);

}  // namespace csgsim::isa
