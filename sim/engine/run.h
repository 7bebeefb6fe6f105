#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hw/machines/timing.h"
#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"

namespace csgsim::engine {

/// All that decides how a run goes on from an instruction boundary. It is the same at every level.
struct RunState {
  Place place;
  bool told_end = false;  ///< observers have been told of the segment's end
  std::uint64_t overflows = 0;
  std::uint64_t skipped = 0;
  std::vector<bool> answers;
  std::vector<machines::Skip> skips;
  /// E, then each memory bit from 0 up, of the segment's pixels, in words as PixelState::read_enable has them. An empty
  /// plane is 0 at every pixel.
  std::vector<std::vector<std::uint64_t>> planes;

  bool operator==(const RunState&) const = default;
};

/// A run of a Program that stops at instruction boundaries, tells its state there and goes on from it.
class Run : public PixelState {
 public:
  static constexpr std::uint64_t end = std::numeric_limits<std::uint64_t>::max();

  /// Pixels are those of the segment of this place. Before the first instruction, and when advance has returned.
  [[nodiscard]] virtual Place place() const = 0;

  /// Whether every segment has been carried out and told of.
  [[nodiscard]] virtual bool finished() const = 0;

  /// Goes on until the number of the next instruction in the whole Program is `number` at least (a skip may pass it),
  /// or to the end. At the end of a segment its pixels stay until the run goes on. Observers are called as by
  /// Engine::run.
  virtual void advance(std::uint64_t number, std::span<Observer* const> observers) = 0;

  /// Of one pixel of the segment, counted from the region's top left.
  [[nodiscard]] virtual std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const = 0;
  [[nodiscard]] virtual bool enabled(std::uint32_t x, std::uint32_t y) const = 0;

  [[nodiscard]] virtual RunState save() const = 0;
  /// The state has to be one of a run of this Program, at whatever level.
  virtual void restore(const RunState& state) = 0;

  /// Of a run that is finished.
  [[nodiscard]] virtual RunResult result() const = 0;
};

}  // namespace csgsim::engine
