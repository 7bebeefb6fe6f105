// Reorders a machine's events into program order for the observers.
// Used by relay and its test.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hw/systemc/run_listener.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// Calls observers in program order, regardless of the order in which segments are drawn. Early events are buffered,
/// with a copy of the pixels if an observer reads them. An observer that reads pixels after its reads_after returned
/// false gets a std::logic_error, whether the event was buffered or not.
class ProgramOrderBuffer {
 public:
  /// Both arguments must outlive the run.
  ProgramOrderBuffer(const isa::Program& program, std::span<engine::Observer* const> observers);

  /// Whether an observer reads the pixels after such an instruction.
  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const;

  /// Called in program order within each segment.
  void after_instruction(const engine::Step& step, const systemc::PixelView& pixels);
  /// Called once per segment, after its instructions.
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels);

 private:
  struct BufferedStep {
    engine::Step step;
    std::unique_ptr<const systemc::PixelView> pixels;  ///< null if no observer reads them
  };

  /// The buffered events of a segment that is not due yet.
  struct BufferedSegment {
    std::vector<BufferedStep> steps;
    std::unique_ptr<const systemc::PixelView> end;  ///< pixels at the end of the segment, if it has ended
  };

  void notify(const engine::Step& step, const systemc::PixelView* pixels) const;
  void notify_segment_end(std::uint32_t segment, const systemc::PixelView& pixels);
  void catch_up();

  const isa::Program& program_;
  std::span<engine::Observer* const> observers_;
  std::uint32_t due_ = 0;              ///< first segment whose events have not all been forwarded
  std::vector<BufferedSegment> held_;  ///< one per segment
};

}  // namespace csgsim::cycle
