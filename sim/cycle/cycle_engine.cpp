#include <algorithm>
#include <deque>
#include <memory>
#include <stdexcept>
#include <utility>

#include "hw/base/error.h"
#include "hw/host/host.h"
#include "hw/kinds/make.h"
#include "hw/machines/runs_on.h"
#include "sim/cycle/clocked_engine.h"
#include "sim/cycle/elaboration.h"
#include "sim/cycle/relay.h"
#include "sim/cycle/sequence.h"
#include "sim/engine/run.h"

namespace csgsim::cycle {

namespace {

engine::RunResult make_result(systemc::RunReport&& report, const Relay& relay, const isa::Program& program,
                              const machines::Machine& machine) {
  engine::RunResult result{.overflows = relay.overflows(),
                           .skipped = report.skipped,
                           .skips = relay.skips(),
                           .answers = std::move(report.answers),
                           .scanned_out = std::move(report.picture)};
  put(host::with_host({.clocks = report.clocks,
                       .shown_clocks = report.shown_clocks,
                       .interval_clocks = report.interval_clocks,
                       .latency_clocks = report.latency_clocks,
                       .account = std::move(report.account)},
                      program, machine),
      result);
  return result;
}

/// Runs a Program, which must be compiled for the machine, on the hardware.
engine::RunResult run_on(systemc::ClockedMachine& hardware, const machines::Machine& machine,
                         const isa::Program& program, std::span<engine::Observer* const> observers) {
  Relay relay(program, observers);
  systemc::RunReport report = hardware.run(program, relay);
  return make_result(std::move(report), relay, program, machine);
}

class CycleEngine final : public engine::Engine {
 public:
  CycleEngine(machines::Machine machine, systemc::ClockedMachine& hardware)
      : machine_(std::move(machine)), hardware_(hardware) {}

  [[nodiscard]] std::string_view level() const override { return "cycle"; }

  engine::RunResult run(const isa::Program& program, std::span<engine::Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    return run_on(hardware_, machine_, program, observers);
  }

  [[nodiscard]] std::unique_ptr<engine::Run> begin(const isa::Program& /*program*/) const override {
    throw InputError(
        "the cycle level cannot pause and resume, since SystemC's kernel cannot be saved; use the functional or the "
        "reference level, whose bits and clocks are the same");
  }

 private:
  machines::Machine machine_;
  systemc::ClockedMachine& hardware_;
};

}  // namespace

systemc::ClockedMachine& clocked_hardware(const machines::Machine& machine, systemc::EvaluatorForm form) {
  claim_elaboration(machine);
  static const std::unique_ptr<systemc::ClockedMachine> hardware = kinds::make_clocked_machine(machine, form);
  static const systemc::EvaluatorForm built = form;
  if (built != form) throw std::logic_error("the machine of this process has trees of another form");
  return *hardware;
}

std::unique_ptr<engine::Engine> make_clocked_engine(const machines::Machine& machine,
                                                    systemc::ClockedMachine& hardware) {
  return std::make_unique<CycleEngine>(machine, hardware);
}

std::vector<engine::RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                            std::span<engine::Observer* const> observers, systemc::EvaluatorForm form) {
  for (const isa::Program& program : programs) machines::check_runs_on(program, machine);
  std::deque<Relay> relays;
  std::vector<systemc::RunListener*> listeners;
  for (std::size_t i = 0; i < programs.size(); ++i)
    listeners.push_back(&relays.emplace_back(programs[i], observers.subspan(i, 1)));
  std::vector<systemc::RunReport> reports = clocked_hardware(machine, form).run_sequence(programs, listeners);
  std::vector<engine::RunResult> results;
  for (std::size_t i = 0; i < reports.size(); ++i)
    results.push_back(make_result(std::move(reports[i]), relays[i], programs[i], machine));
  return results;
}

}  // namespace csgsim::cycle

namespace csgsim {

std::unique_ptr<engine::Engine> engine::make_cycle_engine(const machines::Machine& machine) {
  return cycle::make_clocked_engine(machine, cycle::clocked_hardware(machine));
}

}  // namespace csgsim
