#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/isa/program.h"

namespace csgsim::array {

/// Some pixels of an array, on which a Program is carried out step by step without the machine around them: their
/// memory and their registers are what the machine leaves in them.
class PixelReplay {
 public:
  PixelReplay(std::span<const Place> pixels, std::uint32_t memory_bits, const Sequencer& sequencer, unsigned alu_bits);

  /// A segment begins.
  void begin(const isa::Region& region);
  void execute(const isa::Instruction& instruction);

  /// The same for memory and enable, but for instructions that find no pixel enabled and change nothing then: what they
  /// leave in the other registers is not known afterwards.
  void execute_where_enabled(const isa::Instruction& instruction);

  /// Whether what has been executed since has written all registers of which something was not known.
  [[nodiscard]] bool knows_registers() const {
    return knows_tree_ && knows_carry_ && knows_flag_ && unknown_latches_ == 0;
  }

  [[nodiscard]] const PixelArray& pixels() const { return pixels_; }
  /// The registers between the trees and the pixels.
  [[nodiscard]] const StreamBit& tree() const { return tree_; }

 private:
  void note(const ArrayStep& step);

  PixelArray pixels_;
  StreamBit tree_;
  Sequencer sequencer_;
  std::uint64_t all_latches_;  ///< a bit a bit of the latch
  bool knows_tree_ = true;
  bool knows_carry_ = true;
  bool knows_flag_ = true;
  std::uint64_t unknown_latches_ = 0;
};

}  // namespace csgsim::array
