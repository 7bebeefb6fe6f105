#pragma once

#include "hw/machines/kind.h"
#include "hw/scan_line/figures.h"

namespace csgsim::scan_line {

/// Chains of cells, through which the packets of a line pass.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  void set_picture(Machine& machine, machines::Size size) const override;
  bool keeps_active_list() const override { return true; }
  /// Each line; of an interlaced picture the even ones first.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// Those that an instruction's packet occupies a cell, and so the entry: in which its words come in, or in which the
  /// ports of the cell's memory read its fields and then, not before the last word is in, write the target.
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const Told& told) const override;
  /// When the beats of each packet are at the entry of a chain; the cell of a column works on a beat as many clocks
  /// later as there are cells before it.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine, const Told& told) const override;
  Spans at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                 std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
};

extern const Kind kind;

}  // namespace csgsim::scan_line
