// A session of the debugger: executes its commands on a run of a Program.
// Used by sim/app.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/checkpoint/snapshot.h"
#include "sim/debug/clocks.h"
#include "sim/debug/command.h"
#include "sim/debug/history.h"
#include "sim/debug/stops.h"

namespace csgsim::debug {

/// A debugging session: a run of a Program at the functional level. It begins before the first instruction.
class Session {
 public:
  /// Both references must outlive the session. Throws InputError if the machine cannot run the Program.
  Session(const isa::Program& program, const machines::Machine& machine, unsigned threads = 1);

  /// Executes the command and returns its output, in whole lines. Throws InputError and then changes nothing.
  std::string execute(const Command& command);

  /// Whether the quit command was executed.
  [[nodiscard]] bool is_over() const { return is_over_; }

  [[nodiscard]] const engine::Run& run() const { return *run_; }
  /// Number of the next instruction in the whole Program.
  [[nodiscard]] std::uint64_t number() const { return numbers_.of(run_->place()); }

  /// Words that a command may begin with or contain, for completion.
  [[nodiscard]] std::vector<std::string> words() const;

 private:
  struct Breakpoint {
    std::uint64_t number = 0;
    Target target;
  };

  std::string perform(const Nothing& command);
  std::string perform(const RunOn& command);
  std::string perform(const StepOn& command);
  std::string perform(const Until& command);
  std::string perform(const Back& command);
  std::string perform(const SetBreak& command);
  std::string perform(const DeleteBreak& command);
  std::string perform(const ListBreaks& command);
  std::string perform(const PrintValue& command);
  std::string perform(const PrintPixel& command);
  std::string perform(const PrintEnable& command);
  std::string perform(const Where& command);
  std::string perform(const ListAround& command);
  std::string perform(const TakePicture& command);
  std::string perform(const WriteCheckpoint& command);
  std::string perform(const ReadCheckpoint& command);
  std::string perform(const Help& command);
  std::string perform(const Quit& command);

  /// Runs until `until`, a breakpoint or the end is reached, and returns the reason and the place as text. `target` is
  /// the target of `until`.
  std::string run_to_stop(std::optional<Stop> until, const Target* target);
  /// Runs to that instruction, saving states for stepping back.
  void advance(std::uint64_t number);
  /// Skips trailing segments without instructions after the last instruction has been executed.
  void finish_trailing_segments();
  void save_state();
  [[nodiscard]] checkpoint::Snapshot snapshot() const;
  void restore(const checkpoint::Snapshot& snapshot);
  /// Numbers of the executed instructions, in order.
  [[nodiscard]] std::vector<std::uint64_t> executed() const;
  void check_in_segment(std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] std::string place() const;

  const isa::Program& program_;
  const machines::Machine& machine_;
  engine::Numbers numbers_;
  checkpoint::RunIdentity identity_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<engine::Run> run_;
  observe::FrameObserver frame_;
  observe::StatsObserver stats_;
  Clocks clocks_;
  History history_;
  std::vector<Breakpoint> breakpoints_;
  std::uint64_t next_breakpoint_ = 1;
  bool is_over_ = false;
};

}  // namespace csgsim::debug
