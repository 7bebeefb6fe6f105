#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

/// What of a Program takes the machine's time and memory.
namespace csgsim::multi_processor {

using Subsegments = std::span<const isa::Segment>;

/// The Program's subsegments, a span a segment of the picture.
std::vector<Subsegments> by_segment(const isa::Program& program, const machines::Machine& machine);

/// What the display processor does for a segment and leaves of it, as the host counts.
struct SegmentDivision {
  bool active = false;  ///< the nodes divide
  std::uint64_t boxes = 0;
  std::uint64_t halfspace_tests = 0;
  std::uint64_t cell_tests = 0;
  std::uint64_t primitives = 0;  ///< left
  std::uint64_t halfspaces = 0;  ///< left
};

SegmentDivision division_of(Subsegments parts);

/// A subsegment's, in words of so many bits, each command beginning at a word.
std::uint64_t list_words(const isa::Segment& part, std::uint32_t word_bits);

/// Of the host's link.
std::uint64_t host_words(const isa::Program& program, std::uint32_t word_bits);

}  // namespace csgsim::multi_processor
