#include <memory>
#include <utility>

#include "sim/reference/reference_run.h"

namespace csgsim::sim {

namespace {

class ReferenceEngine final : public Engine {
 public:
  explicit ReferenceEngine(machines::Machine machine) : machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "reference"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    ReferenceRun run(program, machine_);
    run.advance(Run::end, observers);
    return run.result();
  }

  [[nodiscard]] std::unique_ptr<Run> begin(const isa::Program& program) const override {
    return std::make_unique<ReferenceRun>(program, machine_);
  }

 private:
  machines::Machine machine_;
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine(const machines::Machine& machine) {
  return std::make_unique<ReferenceEngine>(machine);
}

}  // namespace csgsim::sim
