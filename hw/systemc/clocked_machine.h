// Interface of all SystemC machines.
// Used by all kinds of machines, hw/kinds and sim/cycle.
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
  std::uint64_t clocks = 0;              ///< total, including latency
  std::uint64_t latency_clocks = 0;      ///< part of the total after the last instruction
  std::uint64_t skipped = 0;             ///< number of skipped instructions
  std::vector<bool> answers;             ///< answers to the host, in order
  machines::Account account{};           ///< clocks by activity
  std::uint64_t shown_clocks = 0;        ///< clocks until the last pixel is shown; 0: equal to `clocks`
  std::uint64_t interval_clocks = 0;     ///< clocks from one frame to the next; 0: equal to `shown_clocks`
  std::vector<std::uint32_t> picture{};  ///< colour of every pixel of the Program, in row order; empty if none is shown
};

/// A machine of any kind, simulated clock by clock. SystemC elaborates once per process, so a process can have only one
/// machine; it runs any number of Programs in sequence. Once it is constructed, SystemC warnings are exceptions.
class ClockedMachine {
 public:
  virtual ~ClockedMachine() = default;

  /// Runs a valid Program (isa::validate) that fits the machine (machines::check_runs_on). Memory and enable are 0 when
  /// a segment begins. Throws InputError before the run if the Program has more pixels or memory than the machine. An
  /// exception of the listener is rethrown after the run.
  virtual RunReport run(const isa::Program& program, RunListener& listener) = 0;

  /// Draws the Programs in sequence, each with its own listener, beginning each as soon as the machine can. By default
  /// that is when the previous one has been shown.
  virtual std::vector<RunReport> run_sequence(std::span<const isa::Program> programs,
                                              std::span<RunListener* const> listeners);

  /// The taps for a wave of a run of the Program, part by part; empty for a kind without waves. Program and machine
  /// must outlive the taps. Throws InputError for a pixel or a tree level that the machine does not have.
  [[nodiscard]] virtual std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const;

  /// Makes the next run begin in the middle of the frame, if the machine can, so that the clocks of the window are as
  /// in a whole run; later clocks may differ. Returns the clock at which the run begins. The run's report is then
  /// meaningless.
  virtual std::uint64_t skip_to(const isa::Program& program, wave::Window window);
};

}  // namespace csgsim::systemc
