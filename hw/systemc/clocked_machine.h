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

struct RunReport {
  std::uint64_t clocks = 0;              ///< in all, latency included
  std::uint64_t latency_clocks = 0;      ///< of these, after the last instruction's
  std::uint64_t skipped = 0;             ///< instructions that were not carried out
  std::vector<bool> answers;             ///< to the host's questions, in order
  machines::Account account{};           ///< what the clocks went into
  std::uint64_t shown_clocks = 0;        ///< until the last pixel is shown; 0: as clocks
  std::uint64_t interval_clocks = 0;     ///< from one frame to the next; 0: as shown_clocks
  std::vector<std::uint32_t> picture{};  ///< colour of every pixel of the Program, in row order; empty if it shows none
};

/// A machine of any kind, clock by clock. SystemC elaborates once a process, so there can be one in a process; it runs
/// any number of Programs one after the other. From its construction on, a SystemC warning is an exception.
class ClockedMachine {
 public:
  virtual ~ClockedMachine() = default;

  /// Runs the Program, which has to be valid (isa::validate) and one for the machine (machines::check_runs_on). Memory
  /// and enable are 0 when a segment begins. Throws InputError before it begins if the Program has more pixels or
  /// memory than the machine. What the listener throws comes out when the machine is done.
  virtual RunReport run(const isa::Program& program, RunListener& listener) = 0;

  /// Draws the Programs one after the other, each with a listener of its own, as soon as the machine can begin the
  /// next; unless a kind says otherwise, that is when the one before it has been shown.
  virtual std::vector<RunReport> run_sequence(std::span<const isa::Program> programs,
                                              std::span<RunListener* const> listeners);

  /// What a wave of a run of the Program shows, part by part; nothing for a kind without waves. Program and machine
  /// have to live as long as the taps. Throws InputError for a pixel or a level of a tree that the machine has not.
  [[nodiscard]] virtual std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const;

  /// Lets the next run begin in the middle of the frame, if the machine can, so that in the clocks of the window all is
  /// as in a whole run; after it nothing need be. Returns the clock with which it will begin. What the run reports is
  /// then of no use.
  virtual std::uint64_t skip_to(const isa::Program& program, wave::Window window);
};

}  // namespace csgsim::systemc
