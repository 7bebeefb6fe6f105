#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>

#include "hw/process/process.h"
#include "sim/judges/truth.h"
#include "sim/studies/fitted_program.h"
#include "sim/studies/inputs.h"
#include "sim/studies/jobs.h"

namespace csgsim::studies {

/// A design, and a model that it draws.
struct ExplorePoint {
  std::string model;
  std::string machine;                       ///< with the figures that were changed
  std::string process;                       ///< that it is made in; empty: it has the clock of its description
  std::optional<std::uint32_t> memory_bits;  ///< that a pixel has; none: as many as its Program takes
  std::uint32_t width = 0;                   ///< pixels
  std::uint32_t height = 0;                  ///< pixels
  unsigned z_bits = 0;
  unsigned fraction_bits = 0;
  unsigned colour_bits = 0;
  std::string pruning;
  std::string colouring;
  std::string strategy;
  unsigned stack_bits = 0;  ///< of strategy bits: m; 0 for the others
  std::string curves;

  static void columns(auto& point, const auto& visit) {
    visit("model", point.model);
    visit("machine", point.machine);
    visit("process", point.process);
    visit("memory_bits", point.memory_bits);
    visit("width", point.width);
    visit("height", point.height);
    visit("z_bits", point.z_bits);
    visit("fraction_bits", point.fraction_bits);
    visit("colour_bits", point.colour_bits);
    visit("pruning", point.pruning);
    visit("colouring", point.colouring);
    visit("strategy", point.strategy);
    visit("stack_bits", point.stack_bits);
    visit("curves", point.curves);
  }
};

/// What a design takes for the model, and how right its picture is. Where `reason` says why it cannot draw it, the
/// counts are 0.
struct ExploreRow {
  static constexpr std::size_t point_columns = 14;

  ExplorePoint point;
  Inputs inputs;
  std::uint64_t halfspaces = 0;       ///< of the model
  std::uint64_t instructions = 0;     ///< in all segments
  std::uint64_t clock_hz = 0;         ///< that the process leaves, or the description says
  std::string clock_path;             ///< what the process leaves no more for; empty without a process, or a price
  std::uint64_t clocks = 0;           ///< until the picture is drawn, latency included
  std::uint64_t interval_clocks = 0;  ///< from one frame to the next
  double frames_per_second = 0;
  std::uint32_t used_bits = 0;                         ///< memory bits a pixel that the Program takes
  std::uint64_t processors = 0;                        ///< of the machine
  std::uint64_t machine_memory_bits = 0;               ///< of all processors, and of a frame buffer beside them
  std::optional<std::uint64_t> pixel_transistors{};    ///< of one processor with its memory: hw/machines/area.h
  std::optional<std::uint64_t> machine_transistors{};  ///< of all processors
  std::optional<double> machine_mm2{};                 ///< of the machine in the process: hw/process/price.h
  std::optional<double> frame_joules{};                ///< of a frame in it
  std::uint64_t wrong = 0;        ///< pixels that differ from the exact picture of the same half-spaces
  std::uint64_t unexplained = 0;  ///< of these, beyond the bounds that docs/numbers.md states
  std::string reason;

  [[nodiscard]] bool drawn() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    ExplorePoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("halfspaces", row.halfspaces);
    visit("instructions", row.instructions);
    visit("clock_hz", row.clock_hz);
    visit("clock_path", row.clock_path);
    visit("clocks", row.clocks);
    visit("interval_clocks", row.interval_clocks);
    visit("frames_per_second", row.frames_per_second);
    visit("used_bits", row.used_bits);
    visit("processors", row.processors);
    visit("machine_memory_bits", row.machine_memory_bits);
    visit("pixel_transistors", row.pixel_transistors);
    visit("machine_transistors", row.machine_transistors);
    visit("machine_mm2", row.machine_mm2);
    visit("frame_joules", row.frame_joules);
    visit("wrong", row.wrong);
    visit("unexplained", row.unexplained);
    visit("reason", row.reason);
  }
};

/// Measures designs, on several threads at the same time. What is the same for many of them is worked out once: the
/// exact picture of a model, how far that of a machine is from it, what a run of a Program tells.
class ExploreMeter {
 public:
  /// Where the point does not say how many memory bits its machine has, it is given just as many as its Program takes;
  /// with a process, the clock that this leaves it.
  ExploreRow measure(const ExplorePoint& point, const Job& job, const std::optional<process::Process>& process);

 private:
  /// How right a picture is.
  struct Verdict {
    std::once_flag once;
    std::uint64_t wrong = 0;
    std::uint64_t unexplained = 0;
  };
  struct Exact {
    std::once_flag once;
    judges::Truth truth;
  };
  /// A model's surfaces, as facets or curved, and a size.
  using Seen = std::tuple<const Subject*, std::uint32_t, std::uint32_t>;
  /// With these and with z bits and fraction bits, every strategy, colouring and pruning draws the same on every
  /// machine (docs/machines.md).
  using Drawn = std::tuple<Seen, unsigned, unsigned>;

  void judge(const Job& job, const Fitted& fitted, ExploreRow& row);
  const judges::Truth& truth_of(const Job& job, const isa::Program& program);

  RunTimer timer_;
  std::mutex lock_;  ///< of the maps, whose entries stay where they are
  std::map<Seen, Exact> truths_;
  std::map<Drawn, Verdict> verdicts_;
};

}  // namespace csgsim::studies
