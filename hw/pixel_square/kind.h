#pragma once

#include "hw/machines/kind.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// The pixel-square kind: renderers that draw squares of the picture into a frame buffer.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  /// Squares of the machine's picture, each as large as a renderer's array and clipped at the right and bottom edges,
  /// in the machine's order. If a divider divides groups of squares first, the squares are listed group by group.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  /// Whether the renderers' controllers can skip instructions by a global OR; no answer returns to the host.
  bool has_global_or(const Machine& machine) const override;
  std::uint32_t host_processor_count(const Machine& machine) const override;
  std::optional<machines::Division> division(const Machine& machine) const override;
  /// Returns the machine with renderers as large as the parts. A segment is divided into the subsegments of thesis 7.4.
  std::optional<Machine> subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const override;
  void check(const Program& program, const Machine& machine) const override;
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const RunOutcome& outcomes) const override;
  /// Clocks in which the controller of the square's renderer has an instruction's steps on its wires; the steps reach
  /// all pixels at once, after the levels of the trees.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine,
                                   const RunOutcome& outcomes) const override;
  Spans spans_at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                       std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
  bool bit_serial_pixels() const override { return true; }
};

extern const Kind kind;

}  // namespace csgsim::pixel_square
