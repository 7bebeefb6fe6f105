#pragma once

#include "hw/machines/kind.h"
#include "hw/pixel_planes/figures.h"

namespace csgsim::pixel_planes {

/// A frame buffer: an array of pixels that holds the whole picture.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  void set_picture(Machine& machine, machines::Size size) const override;
  isa::Field second_buffer(std::uint32_t colour_bits, const Machine& machine) const override;
  bool has_global_or(const Machine& machine) const override;
  std::vector<isa::Region> regions(const Machine& machine) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// As bit_serial_clocks; a question waits for the levels of the global OR too.
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  /// From the clock in which the controller asks for the frame (the modules count the same).
  machines::FrameTiming time(const Program& program, const Machine& machine, const Told& told) const override;
  /// When the controller has the steps of an instruction on its wires, or waits for an answer; and when the steps are
  /// at the pixels, at all of them at once.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine, const Told& told) const override;
  Spans at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                 std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
  bool bit_serial_pixels() const override { return true; }
};

extern const Kind kind;

}  // namespace csgsim::pixel_planes
