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

/// A run of a Program that somebody looks into, at the functional level. It begins before the first instruction.
class Session {
 public:
  /// Both have to outlive it. Throws InputError if the machine cannot run the Program.
  Session(const isa::Program& program, const machines::Machine& machine, unsigned threads = 1);

  /// Carries the command out and returns what it tells, in whole lines. Throws InputError, and has changed nothing
  /// then.
  std::string carry_out(const Command& command);

  /// Whether it has been told to end.
  [[nodiscard]] bool is_over() const { return is_over_; }

  /// Where it is.
  [[nodiscard]] const engine::Run& run() const { return *run_; }
  [[nodiscard]] std::uint64_t number() const { return numbers_.of(run_->place()); }

  /// Words that a command may begin with or name, for completion.
  [[nodiscard]] std::vector<std::string> words() const;

 private:
  struct Breakpoint {
    std::uint64_t number = 0;
    Target target;
  };

  std::string does(const Nothing& command);
  std::string does(const RunOn& command);
  std::string does(const StepOn& command);
  std::string does(const Until& command);
  std::string does(const Back& command);
  std::string does(const SetBreak& command);
  std::string does(const DeleteBreak& command);
  std::string does(const ListBreaks& command);
  std::string does(const PrintValue& command);
  std::string does(const PrintPixel& command);
  std::string does(const PrintEnable& command);
  std::string does(const Where& command);
  std::string does(const ListAround& command);
  std::string does(const TakePicture& command);
  std::string does(const WriteCheckpoint& command);
  std::string does(const ReadCheckpoint& command);
  std::string does(const Help& command);
  std::string does(const Quit& command);

  /// Goes on until one of the stops is reached, and tells why it stopped.
  std::string go(std::optional<Stop> until, const Target* target);
  /// Goes on to that instruction, keeping states for going back.
  void advance(std::uint64_t number);
  /// Past the segments without instructions after the last instruction, if that is carried out.
  void end_if_none_is_left();
  void keep();
  [[nodiscard]] checkpoint::Snapshot snapshot() const;
  void restore(const checkpoint::Snapshot& snapshot);
  /// Numbers of the instructions that have been carried out, in order.
  [[nodiscard]] std::vector<std::uint64_t> carried_out() const;
  void check_seen(std::uint32_t x, std::uint32_t y) const;
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
