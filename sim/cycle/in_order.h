#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "hw/array/pixel_array.h"
#include "sim/engine/engine.h"

namespace csgsim::sim {

/// Calls observers in program order, whatever the order in which segments are drawn. What comes before its turn is
/// kept, with a copy of the pixels where an observer looks at them.
class InOrder {
 public:
  /// `array`: the pixels that a segment is drawn on. All have to live until the run is done.
  InOrder(const isa::Program& program, const isa::ArrayShape& array, std::span<Observer* const> observers);

  /// Before the run: tells of the segments at its beginning that nobody draws.
  void begin() { proceed(); }

  void after_instruction(const Step& step, const array::PixelArray& pixels);
  void after_segment(std::uint32_t segment, const array::PixelArray& pixels);

 private:
  /// Null where no observer looks.
  using Pixels = std::shared_ptr<const array::PixelArray>;

  struct HeldStep {
    Step step;
    Pixels pixels;
  };

  /// A segment before its turn.
  struct Held {
    std::vector<HeldStep> steps;
    Pixels end;  ///< of the segment, if it has come to that
  };

  [[nodiscard]] bool read_after(const isa::Instruction& instruction) const;
  void tell(const Step& step, const array::PixelArray& pixels) const;
  void tell_end(std::uint32_t segment, const array::PixelArray& pixels) const;
  void proceed();

  const isa::Program& program_;
  std::span<Observer* const> observers_;
  array::PixelArray blank_;
  std::uint32_t due_ = 0;  ///< the segment whose turn it is
  std::map<std::uint32_t, Held> held_;
};

}  // namespace csgsim::sim
