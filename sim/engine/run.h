// A run that can stop, and its saved state.
// Used throughout sim.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hw/machines/timing.h"
#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"

namespace csgsim::engine {

/// The complete state of a run at an instruction boundary, the same at every level.
struct RunState {
  Place place;
  bool is_end_reported = false;  ///< observers have been notified of the segment's end
  std::uint64_t overflows = 0;
  std::uint64_t skipped = 0;
  std::vector<bool> answers;
  std::vector<machines::Skip> skips;
  /// E, then each memory bit from 0 up, of the segment's pixels, in the word format of PixelState::read_enable. An
  /// empty plane is 0 at every pixel.
  std::vector<std::vector<std::uint64_t>> planes;

  bool operator==(const RunState&) const = default;
};

/// A run of a Program that stops at instruction boundaries, where its state can be read, saved and restored.
class Run : public PixelState {
 public:
  static constexpr std::uint64_t end = std::numeric_limits<std::uint64_t>::max();

  /// The boundary at which the run is stopped: before the first instruction, or where advance() stopped. The functions
  /// of PixelState read the pixels of its segment.
  [[nodiscard]] virtual Place place() const = 0;

  /// Whether every segment has been executed and observers have been notified.
  [[nodiscard]] virtual bool is_finished() const = 0;

  /// Continues until the number of the next instruction in the whole Program is at least `number` (a skip may pass it),
  /// or to the end. At the end of a segment its pixels stay available until the run continues. Observers are called as
  /// by Engine::run.
  virtual void advance(std::uint64_t number, std::span<Observer* const> observers) = 0;

  /// Value of a field at one pixel of the segment, counted from the region's top left.
  [[nodiscard]] virtual std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const = 0;
  [[nodiscard]] virtual bool is_enabled(std::uint32_t x, std::uint32_t y) const = 0;

  [[nodiscard]] virtual RunState save() const = 0;
  /// The state has to come from a run of this Program, at any level.
  virtual void restore(const RunState& state) = 0;

  /// Result of a finished run.
  [[nodiscard]] virtual RunResult result() const = 0;
};

}  // namespace csgsim::engine
