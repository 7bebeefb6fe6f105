// The machine kind "frame-buffer".
// Used by hw/pixel_planes, sim/rtl and tests.
#pragma once

#include "hw/machines/kind.h"
#include "hw/pixel_planes/figures.h"

namespace csgsim::pixel_planes {

/// Machine kind "frame-buffer": an array of pixels that holds the whole picture.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  void set_picture(Machine& machine, machines::Size size) const override;
  isa::Field second_buffer(std::uint32_t colour_bits, const Machine& machine) const override;
  bool has_global_or(const Machine& machine) const override;
  std::vector<isa::Region> regions(const Machine& machine) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// Same as bit_serial_clocks(), plus the levels of the global OR for a global-OR test.
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  /// Counts from the clock in which the controller requests the frame, like the SystemC modules.
  machines::FrameTiming time(const Program& program, const Machine& machine, const RunOutcome& outcome) const override;
  /// Clocks in which the controller has the steps of an instruction on its wires or waits for an answer, and clocks in
  /// which the steps are at the pixels, which all execute them at the same time.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine,
                                   const RunOutcome& outcome) const override;
  Spans spans_at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                       std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
  bool bit_serial_pixels() const override { return true; }
};

extern const Kind kind;

}  // namespace csgsim::pixel_planes
