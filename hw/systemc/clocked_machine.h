// Interface of all SystemC machines.
// Used by hw and sim/cycle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/systemc/run_listener.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::systemc {

/// Results of one run.
struct RunReport {
  std::uint64_t clocks = 0;          ///< total, including latency
  std::uint64_t latency_clocks = 0;  ///< part of `clocks` after the last instruction
  std::uint64_t skipped = 0;         ///< number of skipped instructions
  std::vector<bool> answers;         ///< results of the global-OR tests that were sent to the host, in order
  machines::Account account{};       ///< clocks by activity
  std::uint64_t shown_clocks = 0;    ///< clocks until the last pixel is shown; 0 if equal to `clocks`
  /// Clocks from the beginning of the frame to that of the next; 0 if equal to `shown_clocks`.
  std::uint64_t interval_clocks = 0;
  /// Colour of every pixel of the Program, in row order; empty if no picture is shown.
  std::vector<std::uint32_t> picture{};
};

/// A machine of any kind, simulated clock by clock. SystemC elaborates once per process, so a process can have only one
/// machine, which can run any number of Programs in sequence. Its constructor turns SystemC warnings into exceptions.
class ClockedMachine {
 public:
  virtual ~ClockedMachine() = default;

  /// Runs a valid Program (isa::validate) that fits the machine (machines::check_runs_on). Memory and enable are 0 when
  /// a segment begins. Throws InputError before the run if the Program has more pixels or memory than the machine. An
  /// exception of the listener is rethrown after the run.
  virtual RunReport run(const isa::Program& program, RunListener& listener) = 0;

  /// Draws the Programs in sequence, each with its own listener. A frame begins as soon as the machine permits; by
  /// default, when the previous picture has been shown.
  virtual std::vector<RunReport> run_sequence(std::span<const isa::Program> programs,
                                              std::span<RunListener* const> listeners);

  /// The taps for a wave of a run of the Program, part by part; empty for a kind without waves. Program and machine
  /// must outlive the taps. Throws InputError for a pixel or tree level that the machine does not have.
  [[nodiscard]] virtual std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const;

  /// If the machine supports it, makes the next run begin in the middle of the frame. The signals in the clocks of the
  /// window are as in a whole run; later clocks may differ, and the report of that run is meaningless. Returns the
  /// clock of the frame at which the run begins.
  virtual std::uint64_t skip_to(const isa::Program& program, wave::Window window);
};

}  // namespace csgsim::systemc
