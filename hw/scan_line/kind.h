#pragma once

#include "hw/machines/kind.h"
#include "hw/scan_line/figures.h"

namespace csgsim::scan_line {

/// The scan-line kind: chains of cells through which the packets of a line pass.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  void set_picture(Machine& machine, machines::Size size) const override;
  bool keeps_active_list() const override { return true; }
  /// One region per line; in an interlaced picture the even lines come first.
  std::vector<isa::Region> regions(const Machine& machine) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// Clocks for which an instruction's packet occupies a cell, and therefore the entry: either its words arrive, or the
  /// ports of the cell's memory read the fields and then write the target, not before the packet's last word.
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const RunOutcome& outcomes) const override;
  /// Clocks in which the beats of each packet are at the entry of a chain. A cell processes a beat one clock later per
  /// preceding cell.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine,
                                   const RunOutcome& outcomes) const override;
  Spans spans_at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                       std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
};

extern const Kind kind;

}  // namespace csgsim::scan_line
