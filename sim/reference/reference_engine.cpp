#include <memory>
#include <utility>

#include "sim/reference/reference_run.h"

namespace csgsim::reference {

namespace {

class ReferenceEngine final : public engine::Engine {
 public:
  explicit ReferenceEngine(machines::Machine machine) : machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "reference"; }

  engine::RunResult run(const isa::Program& program, std::span<engine::Observer* const> observers) override {
    ReferenceRun run(program, machine_);
    run.advance(engine::Run::end, observers);
    return run.result();
  }

  [[nodiscard]] std::unique_ptr<engine::Run> begin(const isa::Program& program) const override {
    return std::make_unique<ReferenceRun>(program, machine_);
  }

 private:
  machines::Machine machine_;
};

}  // namespace

}  // namespace csgsim::reference

namespace csgsim {

std::unique_ptr<engine::Engine> engine::make_reference_engine(const machines::Machine& machine) {
  return std::make_unique<reference::ReferenceEngine>(machine);
}

}  // namespace csgsim
