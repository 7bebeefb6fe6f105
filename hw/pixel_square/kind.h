#pragma once

#include "hw/machines/kind.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Renderers that draw squares of the picture into a frame buffer.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  /// The squares of the machine's picture, as large as a renderer's array, those at the right and bottom edges cut off
  /// there, in the machine's order; where a divider takes groups of squares first, group after group.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  /// Of a renderer's pixels, for who skips instructions; no answer goes back to the host.
  bool has_global_or(const Machine& machine) const override;
  std::uint32_t hosts(const Machine& machine) const override;
  std::optional<machines::Division> division(const Machine& machine) const override;
  /// With renderers as large as the parts. A segment has as many subsegments along a side as those of thesis 7.4.
  std::optional<Machine> subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const override;
  void check(const Program& program, const Machine& machine) const override;
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const Told& told) const override;
  /// When the controller of the renderer that draws the square has an instruction's steps on its wires; they come to
  /// all of its pixels at once, through the levels of its trees.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine, const Told& told) const override;
  Spans at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                 std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
  bool bit_serial_pixels() const override { return true; }
};

extern const Kind kind;

}  // namespace csgsim::pixel_square
