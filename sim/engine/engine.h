// Interfaces of engines, observers and pixel state.
// Used throughout sim.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "sim/engine/work.h"

namespace csgsim::engine {

class Run;

/// The state of a segment's pixels at an instruction boundary. Pixels are in row order from the region's top left.
class PixelState {
 public:
  virtual ~PixelState() = default;

  [[nodiscard]] virtual isa::Region region() const = 0;

  /// The field's value at every pixel; `values` holds region width * height of them.
  virtual void read_field(isa::Field field, std::span<std::uint32_t> values) const = 0;

  /// Enable bits, 64 pixels per word (pixel x is bit x % 64 of word x / 64), each row padded to whole words;
  /// `words` holds ceil(width / 64) * height of them. Padding bits are zero.
  virtual void read_enable(std::span<std::uint64_t> words) const = 0;
};

/// An executed instruction; skipped instructions produce no step.
struct Step {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< within the segment
  const isa::Instruction& instruction;
  std::uint64_t clocks = 0;
  std::uint64_t enabled_pixels = 0;  ///< pixels whose E was 1 when the instruction began
  /// Clocks at the pixels, for kinds of machines that measure them; otherwise each pixel needs `clocks`.
  std::optional<machines::PixelClocks> at_pixels{};
};

/// Observes a run. Every function except enabled_after is called in program order, from one thread at a time.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Whether after_instruction reads the state after such an instruction. If no observer does, engines may run ahead
  /// and call it later.
  [[nodiscard]] virtual bool reads_after(const isa::Instruction& /*instruction*/) const { return true; }
  virtual void after_instruction(const Step& /*step*/, const PixelState& /*state*/) {}

  /// Whether after_instruction reads only the enabled pixels after such an instruction, for which reads_after is true.
  /// Engines may then call enabled_after instead.
  [[nodiscard]] virtual bool reads_enable_alone(const isa::Instruction& /*instruction*/) const { return false; }
  /// Called for parts of the picture that together have all enabled pixels: from several threads for disjoint parts,
  /// but in program order for each part. `words` has the format of PixelState::read_enable, for the part.
  virtual void enabled_after(const isa::Instruction& /*instruction*/, const isa::Region& /*part*/,
                             std::span<const std::uint64_t> /*words*/) {}
  virtual void after_segment(std::uint32_t /*segment*/, const PixelState& /*state*/) {}
};

struct RunResult {
  std::uint64_t clocks = 0;  ///< total, including latency
  /// Part of `clocks` until the last instruction reaches the pixels, if the array covers the whole picture.
  std::uint64_t latency_clocks = 0;
  std::uint64_t shown_clocks = 0;       ///< see machines::FrameTiming
  std::uint64_t interval_clocks = 0;    ///< see machines::FrameTiming
  std::uint64_t host_clocks = 0;        ///< see machines::FrameTiming
  std::uint64_t host_model_clocks = 0;  ///< see machines::FrameTiming
  /// Enabled pixels at which A*x + B*y + C exceeded the width although it must fit (isa::may_exceed_width); 0 if not
  /// checked.
  std::uint64_t overflows = 0;
  std::uint64_t skipped = 0;            ///< instructions skipped by skip_if_none
  std::vector<machines::Skip> skips{};  ///< the skip_if_none instructions that skipped, in program order
  /// Pixels at which instructions took effect, per segment, for kinds that need it; empty at the cycle level, whose
  /// clocks are counted.
  std::vector<machines::PixelActivity> pixel_activity{};
  std::vector<bool> answers;  ///< results of the global_or instructions, in program order
  /// Colour of every pixel of the picture, in row order, from the machine's scan-out; empty if the engine does not
  /// simulate it.
  std::vector<std::uint32_t> scanned_out{};
  machines::Account account{};  ///< the machine kind's account of the frame
  Work work{};                  ///< work done by the functional engine
};

/// Run-time outcomes that exact timing needs. They refer to the result, which must outlive them.
inline machines::RunOutcome run_outcome(const RunResult& result) { return {result.skips, result.pixel_activity}; }

/// Stores the timing of a frame in the result of its run.
inline void put(machines::FrameTiming timing, RunResult& result) {
  result.clocks = timing.clocks;
  result.shown_clocks = timing.shown_clocks;
  result.interval_clocks = timing.interval_clocks;
  result.host_clocks = timing.host_clocks;
  result.host_model_clocks = timing.host_model_clocks;
  result.latency_clocks = timing.latency_clocks;
  result.account = std::move(timing.account);
}

/// The timing of a frame that put() stored in the result of its run.
inline machines::FrameTiming timing_of(const RunResult& result) {
  return {.clocks = result.clocks,
          .shown_clocks = result.shown_clocks,
          .interval_clocks = result.interval_clocks,
          .latency_clocks = result.latency_clocks,
          .account = result.account,
          .host_clocks = result.host_clocks,
          .host_model_clocks = result.host_model_clocks};
}

/// The rates at which the machine draws the frame repeatedly.
inline machines::FrameRates frame_rates(const RunResult& result, const machines::Machine& machine) {
  return machines::frame_rates(machine.clock_hz, result.interval_clocks, result.host_clocks);
}

/// Runs Programs at one level of fidelity. All levels produce the same memory and enable bits at every instruction
/// boundary and the same clock counts. Memory and enable bits are 0 when a segment begins.
class Engine {
 public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual std::string_view level() const = 0;

  /// Runs every segment. Observers are called in the given order. The Program must be valid (isa::validate). Throws
  /// InputError before the start if the machine lacks a feature that the Program needs (machines::check_runs_on).
  virtual RunResult run(const isa::Program& program, std::span<Observer* const> observers) = 0;

  /// A run that can stop and continue (sim/engine/run.h), at its first instruction. The Program has to outlive it.
  /// Throws as run does, and InputError if the level cannot stop.
  [[nodiscard]] virtual std::unique_ptr<Run> begin(const isa::Program& program) const = 0;
};

std::unique_ptr<Engine> make_reference_engine(const machines::Machine& machine);
/// Runs tiles of pixels on `threads` threads, which meet after each instruction whose state an observer reads. Results
/// do not depend on the number of threads.
std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine, unsigned threads = 1);
std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine);

}  // namespace csgsim::engine
