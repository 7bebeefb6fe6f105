#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "hw/base/error.h"
#include "hw/kinds/make.h"
#include "hw/machines/runs_on.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/cycle/elaboration.h"
#include "sim/cycle/relay.h"
#include "sim/cycle/sequence.h"
#include "sim/engine/run.h"

namespace csgsim::sim {

namespace {

RunResult result_of(kernel::RunReport&& report, const Relay& relay) {
  RunResult result{.overflows = relay.overflows(),
                   .skipped = report.skipped,
                   .skips = relay.skips(),
                   .answers = std::move(report.answers),
                   .scanned_out = std::move(report.picture)};
  put(machines::with_pace({.clocks = report.clocks,
                           .shown_clocks = report.shown_clocks,
                           .interval_clocks = report.interval_clocks,
                           .latency_clocks = report.latency_clocks,
                           .account = std::move(report.account)}),
      result);
  return result;
}

/// The Program has to be one for the machine.
RunResult run_on(kernel::ClockedMachine& hardware, const isa::Program& program, std::span<Observer* const> observers) {
  Relay relay(program, observers);
  kernel::RunReport report = hardware.run(program, relay);
  return result_of(std::move(report), relay);
}

class CycleEngine final : public Engine {
 public:
  CycleEngine(machines::Machine machine, kernel::ClockedMachine& hardware)
      : machine_(std::move(machine)), hardware_(hardware) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    return run_on(hardware_, program, observers);
  }

  [[nodiscard]] std::unique_ptr<Run> begin(const isa::Program& /*program*/) const override {
    throw InputError(
        "the cycle level cannot stop and go on, since SystemC's kernel cannot be saved; take the functional or the "
        "reference level, whose bits and clocks are the same");
  }

 private:
  machines::Machine machine_;
  kernel::ClockedMachine& hardware_;
};

}  // namespace

kernel::ClockedMachine& clocked_hardware(const machines::Machine& machine) {
  claim_elaboration(machine);
  static const std::unique_ptr<kernel::ClockedMachine> hardware = kinds::make_clocked_machine(machine);
  return *hardware;
}

std::unique_ptr<Engine> make_clocked_engine(const machines::Machine& machine, kernel::ClockedMachine& hardware) {
  return std::make_unique<CycleEngine>(machine, hardware);
}

std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine) {
  return make_clocked_engine(machine, clocked_hardware(machine));
}

std::vector<RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                    std::span<Observer* const> observers) {
  for (const isa::Program& program : programs) machines::check_runs_on(program, machine);
  std::deque<Relay> relays;
  std::vector<kernel::RunListener*> listeners;
  for (std::size_t i = 0; i < programs.size(); ++i)
    listeners.push_back(&relays.emplace_back(programs[i], observers.subspan(i, 1)));
  std::vector<kernel::RunReport> reports = clocked_hardware(machine).run_sequence(programs, listeners);
  std::vector<RunResult> results;
  for (std::size_t i = 0; i < reports.size(); ++i) results.push_back(result_of(std::move(reports[i]), relays[i]));
  return results;
}

}  // namespace csgsim::sim
