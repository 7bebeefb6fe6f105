#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hw/systemc/run_listener.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// Calls observers in program order, whatever the order in which segments are drawn. What comes before its turn is
/// kept, with a copy of the pixels where an observer looks at them. To look after an instruction without having said so
/// is a std::logic_error, whether it had to be kept or not.
class InOrder {
 public:
  /// Both have to live until the run is done.
  InOrder(const isa::Program& program, std::span<engine::Observer* const> observers);

  /// Whether an observer looks at the pixels after such an instruction.
  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const;

  /// Within a segment in program order.
  void after_instruction(const engine::Step& step, const systemc::PixelView& pixels);
  /// Once a segment, after its instructions.
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels);

 private:
  struct HeldStep {
    engine::Step step;
    std::unique_ptr<const systemc::PixelView> pixels;  ///< null where no observer looks
  };

  /// A segment before its turn.
  struct Held {
    std::vector<HeldStep> steps;
    std::unique_ptr<const systemc::PixelView> end;  ///< of the segment, if it has come to that
  };

  void tell(const engine::Step& step, const systemc::PixelView* pixels) const;
  void tell_end(std::uint32_t segment, const systemc::PixelView& pixels);
  void catch_up();

  const isa::Program& program_;
  std::span<engine::Observer* const> observers_;
  std::uint32_t due_ = 0;   ///< the segment whose turn it is
  std::vector<Held> held_;  ///< one a segment
};

}  // namespace csgsim::cycle
