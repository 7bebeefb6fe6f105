#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/kinds/make.h"
#include "hw/machines/kind.h"
#include "hw/machines/runs_on.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/cycle/elaboration.h"
#include "sim/cycle/record.h"
#include "sim/cycle/relay.h"
#include "sim/cycle/sequence.h"

namespace csgsim::sim {

namespace {

/// The one machine of the process.
kernel::ClockedMachine& hardware_of(const machines::Machine& machine) {
  claim_elaboration(machine);
  static const std::unique_ptr<kernel::ClockedMachine> hardware = kinds::make_clocked_machine(machine);
  return *hardware;
}

RunResult result_of(kernel::RunReport&& report, const Relay& relay) {
  RunResult result{.overflows = relay.overflows(),
                   .skipped = report.skipped,
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
RecordedRun run_on(kernel::ClockedMachine& hardware, const isa::Program& program,
                   std::span<Observer* const> observers) {
  Relay relay(program, observers);
  kernel::RunReport report = hardware.run(program, relay);
  const bool recorded = report.recorded;
  return {.result = result_of(std::move(report), relay), .window_reached = recorded};
}

class CycleEngine final : public Engine {
 public:
  CycleEngine(machines::Machine machine, kernel::ClockedMachine& hardware)
      : machine_(std::move(machine)), hardware_(hardware) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    return run_on(hardware_, program, observers).result;
  }

 private:
  machines::Machine machine_;
  kernel::ClockedMachine& hardware_;
};

}  // namespace

std::unique_ptr<Engine> make_clocked_engine(const machines::Machine& machine, kernel::ClockedMachine& hardware) {
  return std::make_unique<CycleEngine>(machine, hardware);
}

std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine) {
  return make_clocked_engine(machine, hardware_of(machine));
}

RecordedRun run_and_record(const machines::Machine& machine, const isa::Program& program,
                           std::span<Observer* const> observers, const kernel::WaveRequest& request) {
  kernel::ClockedMachine& hardware = hardware_of(machine);
  if (!hardware.can_record()) {
    throw InputError("machines of the kind " + std::string(machine.kind->name) +
                     " have no waves; take another --machine");
  }
  machines::check_runs_on(program, machine);
  hardware.record(request);
  return run_on(hardware, program, observers);
}

std::vector<RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                    std::span<Observer* const> observers) {
  for (const isa::Program& program : programs) machines::check_runs_on(program, machine);
  std::deque<Relay> relays;
  std::vector<kernel::RunListener*> listeners;
  for (std::size_t i = 0; i < programs.size(); ++i)
    listeners.push_back(&relays.emplace_back(programs[i], observers.subspan(i, 1)));
  std::vector<kernel::RunReport> reports = hardware_of(machine).run_sequence(programs, listeners);
  std::vector<RunResult> results;
  for (std::size_t i = 0; i < reports.size(); ++i) results.push_back(result_of(std::move(reports[i]), relays[i]));
  return results;
}

}  // namespace csgsim::sim
