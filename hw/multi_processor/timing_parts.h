#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/timing_model.h"

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

/// Of a node that unpacks what it looks at: a box, a half-space without its colour, a node of the tree.
TestClocks node_test_clocks(const ModelSizes& sizes, const Figures& figures);

/// A subsegment's, in words of so many bits, each command beginning at a word.
std::uint64_t list_words(const isa::Segment& part, std::uint32_t word_bits);

/// Of the host's link.
std::uint64_t host_words(const isa::Program& program, std::uint32_t word_bits);

/// What is in the display processor's memory.
struct DisplayMemory {
  std::uint64_t model_words = 0;
  bool has_planes =
      true;  ///< else the model is there without its planes, which are read from the host when they are tested

  /// Is there memory for what a segment leaves, besides?
  [[nodiscard]] bool holds(const SegmentDivision& division, const ModelSizes& sizes, const Figures& figures) const;
};

DisplayMemory display_memory(const isa::Program& program, const ModelSizes& sizes, const Figures& figures);

/// To read a plane from the host and transform it.
std::uint64_t far_plane_clocks(const ModelSizes& sizes, const Figures& figures);

}  // namespace csgsim::multi_processor
