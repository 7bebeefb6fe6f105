// Replays a Program on some pixels without a machine.
// Used by hw/pixel_planes/probed.h and sim/waves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/isa/program.h"

namespace csgsim::array {

/// Executes a Program step by step on some pixels of an array, without the machine around them. Memory and registers
/// end up as in the machine.
class PixelReplay {
 public:
  PixelReplay(std::span<const Place> pixels, std::uint32_t memory_bits, const Sequencer& sequencer, unsigned alu_bits);

  /// Begins a segment.
  void begin(const isa::Region& region);
  void execute(const isa::Instruction& instruction);

  /// Like execute(), but skips an instruction that would change neither memory nor enable bits because no pixel is
  /// enabled. The other registers are unknown afterwards.
  void execute_where_enabled(const isa::Instruction& instruction);

  /// Whether all registers are known, because later instructions have overwritten the unknown ones.
  [[nodiscard]] bool registers_known() const {
    return tree_known_ && carry_known_ && flag_known_ && unknown_latches_ == 0;
  }

  [[nodiscard]] const PixelArray& pixels() const { return pixels_; }
  /// The registers between the trees and the pixels.
  [[nodiscard]] const StreamBit& tree() const { return tree_; }

 private:
  void record_known_registers(const ArrayStep& step);

  PixelArray pixels_;
  StreamBit tree_;
  Sequencer sequencer_;
  std::uint64_t all_latches_;  ///< one bit per bit of the latch
  bool tree_known_ = true;
  bool carry_known_ = true;
  bool flag_known_ = true;
  std::uint64_t unknown_latches_ = 0;
};

}  // namespace csgsim::array
