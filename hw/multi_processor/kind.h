#pragma once

#include "hw/machines/kind.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

/// Nodes that carry out a segment's list at their pixels, and a display processor that divides the model.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  /// Subsegments, segment by segment: as many of each as there are nodes.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  /// A segment's subsegments are divided from whatever the segment leaves.
  std::optional<machines::Division> division(const Machine& machine) const override;
  /// The nodes share a segment; one draws it as a whole.
  std::optional<Machine> subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// Where nodes branch over what is disabled.
  bool asks_for_pixels(const Machine& machine) const override;
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::PixelClocks clocks_at_pixels(const isa::Segment& segment, std::size_t index, const Machine& machine,
                                         const machines::MetPixels* met) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const Told& told) const override;
  /// When the first node begins with an instruction at its first pixel of the subsegment, until the last is through
  /// with its last; and when the node that has a pixel is at that.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine, const Told& told) const override;
  Spans at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                 std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
};

extern const Kind kind;

}  // namespace csgsim::multi_processor
