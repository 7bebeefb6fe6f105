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

  /// Enable bits, 64 pixels a word (pixel x is bit x % 64 of word x / 64), each row padded to whole words;
  /// `words` holds ceil(width / 64) * height of them. Padding bits are zero.
  virtual void read_enable(std::span<std::uint64_t> words) const = 0;
};

/// An instruction that has just been carried out; one that is skipped is none.
struct Step {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< within the segment
  const isa::Instruction& instruction;
  std::uint64_t clocks = 0;
  std::uint64_t enabled_pixels = 0;  ///< pixels whose E was 1 when the instruction began
  /// What it took at the pixels, of a kind that asks for them; elsewhere it takes `clocks` at each.
  std::optional<machines::PixelClocks> at_pixels{};
};

/// Sees a run go by. Every function is called in program order, from one thread at a time, but for enabled_after.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Whether after_instruction looks at the state after such an instruction. Where none does, engines may run ahead
  /// and call it later.
  [[nodiscard]] virtual bool reads_after(const isa::Instruction& /*instruction*/) const { return true; }
  virtual void after_instruction(const Step& /*step*/, const PixelState& /*state*/) {}

  /// Whether all that after_instruction looks at after such an instruction, which reads_after names, is which pixels
  /// are enabled. Engines may then call enabled_after in its place.
  [[nodiscard]] virtual bool reads_enable_alone(const isa::Instruction& /*instruction*/) const { return false; }
  /// For parts of the picture that have all the enabled pixels: from several threads, for parts without a common pixel,
  /// but in program order for each part. `words` are as PixelState::read_enable has them, of the part.
  virtual void enabled_after(const isa::Instruction& /*instruction*/, const isa::Region& /*part*/,
                             std::span<const std::uint64_t> /*words*/) {}
  virtual void after_segment(std::uint32_t /*segment*/, const PixelState& /*state*/) {}
};

struct RunResult {
  std::uint64_t clocks = 0;  ///< in all, latency included
  std::uint64_t latency_clocks =
      0;  ///< of these, for the last instruction to reach the pixels, where the array is the whole picture
  std::uint64_t shown_clocks = 0;     ///< as machines::FrameTiming
  std::uint64_t interval_clocks = 0;  ///< as machines::FrameTiming
  std::uint64_t host_clocks = 0;      ///< as machines::FrameTiming
  /// Enabled pixels at which A*x + B*y + C did not fit the width, but had to (isa::cuts_sum); 0 if not checked.
  std::uint64_t overflows = 0;
  std::uint64_t skipped = 0;            ///< instructions that a skip_if_none left out
  std::vector<machines::Skip> skips{};  ///< which skip_if_none left them out, in program order
  /// Which pixels instructions met, one a segment, for a kind that asks; empty of the cycle level, whose clocks are
  /// counted.
  std::vector<machines::MetPixels> met{};
  std::vector<bool> answers;  ///< of global_or, in order
  /// Colour of every pixel of the picture, in row order, as the machine's scan-out delivers it; empty where the engine
  /// simulates none.
  std::vector<std::uint32_t> scanned_out{};
  machines::Account account{};  ///< what the machine's kind tells of the frame
  Work work{};                  ///< what the functional engine did for it
};

/// What a run tells for working out clocks, as long as the result is there.
inline machines::Told told_of(const RunResult& result) { return {result.skips, result.met}; }

/// What a frame took, into what its run tells.
inline void put(machines::FrameTiming timing, RunResult& result) {
  result.clocks = timing.clocks;
  result.shown_clocks = timing.shown_clocks;
  result.interval_clocks = timing.interval_clocks;
  result.host_clocks = timing.host_clocks;
  result.latency_clocks = timing.latency_clocks;
  result.account = std::move(timing.account);
}

/// Runs Programs at one level of fidelity. All levels leave the same bits in memory and enable at every instruction
/// boundary and take the same clocks. Memory and enable are 0 when a segment begins.
class Engine {
 public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual std::string_view level() const = 0;

  /// Runs every segment. Observers are called in the order given. The Program must be valid (isa::validate). Throws
  /// InputError before it begins if the machine lacks what the Program needs (machines::check_runs_on).
  virtual RunResult run(const isa::Program& program, std::span<Observer* const> observers) = 0;

  /// A run that can stop and go on (sim/engine/run.h), at its first instruction. The Program has to outlive it. Throws
  /// as run does, and InputError where a level cannot stop.
  [[nodiscard]] virtual std::unique_ptr<Run> begin(const isa::Program& program) const = 0;
};

std::unique_ptr<Engine> make_reference_engine(const machines::Machine& machine);
/// Runs on that many threads between the instructions after which an observer looks at the state. Bits do not depend on
/// it.
std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine, unsigned threads = 1);
std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine);

}  // namespace csgsim::engine
