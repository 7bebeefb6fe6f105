#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "sim/engine/engine.h"
#include "sim/functional/array.h"

namespace csgsim::sim {

/// The pixels of one segment after another, as bands of rows that a thread each can work on, since instructions look at
/// no pixel but their own.
class Bands final : public PixelState {
 public:
  /// At most `count` bands of a region's rows.
  Bands(const isa::Program& program, unsigned count) : program_(program), count_(count) {}

  /// Memory and enable 0, as a segment begins.
  void begin(const isa::Region& region);

  struct Tally {
    std::vector<std::uint64_t> enabled;  ///< pixels whose E was 1 when each instruction began
    std::uint64_t overflows = 0;         ///< enabled pixels at which A*x + B*y + C did not fit its width
  };

  /// Carries out the instructions, a thread a band.
  Tally execute(std::span<const isa::Instruction> instructions);

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

 private:
  const isa::Program& program_;
  unsigned count_;
  isa::Region region_;
  std::vector<Array> arrays_;
};

}  // namespace csgsim::sim
