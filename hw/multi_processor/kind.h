#pragma once

#include "hw/machines/kind.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

/// The multi-processor kind: nodes that execute a segment's list at their pixels, and a display processor that divides
/// the model.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  /// Computes the clocks that the description leaves to the processors.
  void complete(Machine& machine) const override;
  /// Subsegments, segment by segment; each segment has one per node.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  /// A segment's subsegments are divided from the survivors of the segment.
  std::optional<machines::Division> division(const Machine& machine) const override;
  /// Returns the machine with `levels` halvings of the picture into segments, and all its nodes if `parts` are
  /// subsegments, or one node if `parts` are whole segments.
  std::optional<Machine> subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// Whether nodes branch over disabled pixels.
  bool depends_on_pixels(const Machine& machine) const override;
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::PixelClocks clocks_at_pixels(const isa::Segment& segment, std::size_t index, const Machine& machine,
                                         const machines::PixelActivity* pixel_activity) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const RunOutcome& outcomes) const override;
  /// Clocks from the first node's start of an instruction at its first pixel of the subsegment to the last node's end
  /// at its last pixel; spans_at_pixel gives the clocks of the node that holds the pixel.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine,
                                   const RunOutcome& outcomes) const override;
  Spans spans_at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                       std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
};

extern const Kind kind;

}  // namespace csgsim::multi_processor
