#include "sim/engine/engine.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "sim/functional/run.h"

namespace csgsim::sim {

namespace {

class FunctionalEngine final : public Engine {
 public:
  FunctionalEngine(machines::Machine machine, unsigned threads) : machine_(std::move(machine)), threads_(threads) {
    if (threads == 0) throw std::invalid_argument("no thread to run on");
  }

  [[nodiscard]] std::string_view level() const override { return "functional"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    FunctionalRun run(program, machine_, threads_);
    run.advance(Run::end, observers);
    return run.result();
  }

  [[nodiscard]] std::unique_ptr<Run> begin(const isa::Program& program) const override {
    return std::make_unique<FunctionalRun>(program, machine_, threads_);
  }

 private:
  machines::Machine machine_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine, unsigned threads) {
  return std::make_unique<FunctionalEngine>(machine, threads);
}

}  // namespace csgsim::sim
