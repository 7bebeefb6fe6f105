// The bit-serial-memory kind of machine. Used by sim/app and sim/rows.
#pragma once

#include "hw/bit_serial_memory/figures.h"
#include "hw/machines/kind.h"

namespace csgsim::bit_serial_memory {

/// The bit-serial-memory kind: DRAM chips whose subarrays compute; a column holds a pixel, and a row holds one bit of
/// pixel memory.
class Kind final : public machines::KindOf<Figures> {
 public:
  using KindOf::KindOf;

  void complete(Machine& machine) const override;
  void set_picture(Machine& machine, machines::Size size) const override;
  /// Always true: the wired OR, or the host, which reads the row of enable bits, computes the global OR.
  bool has_global_or(const Machine& /*machine*/) const override { return true; }
  std::vector<isa::Region> regions(const Machine& machine) const override;
  void check(const Program& program, const Machine& machine) const override;
  /// One clock to take the instruction, and the clocks of its row commands in all subarrays that hold pixels.
  std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const override;
  machines::FrameTiming time(const Program& program, const Machine& machine, const RunOutcome& outcomes) const override;
  /// Clocks in which the row commands of an instruction are executed at all pixels.
  std::optional<Timeline> timeline(const Program& program, const Machine& machine,
                                   const RunOutcome& outcomes) const override;
  Spans spans_at_pixel(const Timeline& timeline, const Program& program, const Machine& machine, std::uint32_t segment,
                       std::uint32_t x, std::uint32_t y) const override;
  machines::Resources resources(const Machine& machine, const isa::FrameHeader& header) const override;
  std::vector<machines::Load> loads(const machines::FrameTiming& timing) const override;
  bool is_costly() const override { return true; }
};

extern const Kind kind;

}  // namespace csgsim::bit_serial_memory
