#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/timing_model.h"

/// Time and memory that the parts of a Program take.
namespace csgsim::multi_processor {

using Subsegments = std::span<const isa::Segment>;

/// The Program's subsegments, one span per segment of the picture.
std::vector<Subsegments> subsegments_by_segment(const isa::Program& program, const machines::Machine& machine);

/// Work of the display processor for a segment, and its survivors, as counted by the host.
struct SegmentDivision {
  bool active = false;  ///< the nodes divide
  std::uint64_t boxes = 0;
  std::uint64_t halfspace_tests = 0;
  std::uint64_t cell_tests = 0;
  std::uint64_t primitives = 0;  ///< surviving primitives
  std::uint64_t halfspaces = 0;  ///< surviving half-spaces
};

SegmentDivision segment_division(Subsegments parts);

/// Test clocks of a node, including unpacking of a box, a half-space without its colour, or a node of the tree.
TestClocks node_test_clocks(const ModelSizes& sizes, const Figures& figures);

/// Words of a subsegment's list; each command begins at a new word.
std::uint64_t list_words(const isa::Segment& part, std::uint32_t word_bits);

/// Words of the display model, and of its length, on the host's link.
std::uint64_t host_words(const isa::Program& program, std::uint32_t word_bits);

/// Contents of the display processor's memory.
struct DisplayMemory {
  std::uint64_t model_words = 0;
  bool has_planes =
      true;  ///< otherwise the model is stored without its planes, which are read from the host when tested

  /// Whether the display processor's memory has room for the survivors of a segment in addition.
  [[nodiscard]] bool can_hold(const SegmentDivision& division, const ModelSizes& sizes, const Figures& figures) const;
};

DisplayMemory display_memory(const isa::Program& program, const ModelSizes& sizes, const Figures& figures);

/// Clocks to read a plane from the host and transform it.
std::uint64_t remote_plane_clocks(const ModelSizes& sizes, const Figures& figures);

}  // namespace csgsim::multi_processor
