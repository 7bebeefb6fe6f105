#include "sim/engine/engine.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "sim/functional/run.h"

namespace csgsim::functional {

namespace {

class FunctionalEngine final : public engine::Engine {
 public:
  FunctionalEngine(machines::Machine machine, unsigned threads) : machine_(std::move(machine)), threads_(threads) {
    if (threads == 0) throw std::invalid_argument("no thread to run on");
  }

  [[nodiscard]] std::string_view level() const override { return "functional"; }

  engine::RunResult run(const isa::Program& program, std::span<engine::Observer* const> observers) override {
    FunctionalRun run(program, machine_, threads_);
    run.advance(engine::Run::end, observers);
    return run.result();
  }

  [[nodiscard]] std::unique_ptr<engine::Run> begin(const isa::Program& program) const override {
    return std::make_unique<FunctionalRun>(program, machine_, threads_);
  }

 private:
  machines::Machine machine_;
  unsigned threads_;
};

}  // namespace

}  // namespace csgsim::functional

namespace csgsim {

std::unique_ptr<engine::Engine> engine::make_functional_engine(const machines::Machine& machine, unsigned threads) {
  return std::make_unique<functional::FunctionalEngine>(machine, threads);
}

}  // namespace csgsim
