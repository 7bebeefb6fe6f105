// lockstep_models WIDTH HEIGHT JUDGE MODEL...: draws test models at the judge's level and at the cycle level and
// compares all of memory and enable, the clocks and the enabled pixels at every instruction boundary. One picture size
// per process, as SystemC elaborates once.

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/facts.h"
#include "tests/lockstep/lockstep.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

namespace {

/// Digest of a run at one instruction boundary.
struct Trace {
  std::uint64_t clocks = 0;
  std::uint64_t enabled = 0;
  std::size_t bits = 0;  ///< hash of memory and enable

  bool operator==(const Trace&) const = default;
};

class TraceObserver : public engine::Observer {
 public:
  explicit TraceObserver(const isa::Program& program) : program_(program) {}

  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    const isa::Region region = state.region();
    values_.resize(static_cast<std::size_t>(region.width) * region.height);
    enable_.resize(static_cast<std::size_t>((region.width + 63) / 64) * region.height);
    std::size_t bits = 0;
    for (const isa::NamedField& named : program_.facts->fields) {
      state.read_field(named.field, values_);
      mix(bits, values_);
    }
    state.read_enable(enable_);
    mix(bits, enable_);
    traces.push_back({step.clocks, step.enabled_pixels, bits});
  }

  std::vector<Trace> traces;

 private:
  template <typename Word>
  static void mix(std::size_t& bits, const std::vector<Word>& words) {
    const std::string_view bytes(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(Word));
    bits = bits * 31 + std::hash<std::string_view>{}(bytes);
  }

  const isa::Program& program_;
  std::vector<std::uint32_t> values_;
  std::vector<std::uint64_t> enable_;
};

std::vector<Trace> trace(engine::Engine& engine, const isa::Program& program, engine::RunResult& result) {
  TraceObserver observer(program);
  const std::array<engine::Observer*, 1> observers{&observer};
  result = engine.run(program, observers);
  return std::move(observer.traces);
}

void compare(engine::Engine& judge, engine::Engine& engine, const std::string& model, const isa::Program& program) {
  engine::RunResult expected;
  engine::RunResult actual;
  const std::vector<Trace> judged = trace(judge, program, expected);
  const std::vector<Trace> traced = trace(engine, program, actual);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (i >= traced.size() || !(judged[i] == traced[i])) {
      throw std::runtime_error(
          fmt::format("{}: {} and {} differ after instruction {}", model, judge.level(), engine.level(), i));
    }
  }
  if (judged.size() != traced.size() || expected.clocks != actual.clocks) {
    throw std::runtime_error(fmt::format("{}: {} takes {} clocks but {} takes {}", model, judge.level(),
                                         expected.clocks, engine.level(), actual.clocks));
  }
  fmt::print("{}: {} instructions, {} clocks, equal\n", model, judged.size(), actual.clocks);
}

void run(const std::vector<std::string>& arguments) {
  Setup setup;
  setup.sampling.width = static_cast<std::uint32_t>(std::stoul(arguments.at(0)));
  setup.sampling.height = static_cast<std::uint32_t>(std::stoul(arguments.at(1)));
  const machines::Machine machine =
      test::machine_of({setup.sampling.width, setup.sampling.height, setup.memory_bits}, 1);
  const auto judge =
      arguments.at(2) == "reference" ? engine::make_reference_engine(machine) : engine::make_functional_engine(machine);
  const auto engine = engine::make_cycle_engine(machine);
  for (std::size_t i = 3; i < arguments.size(); ++i) {
    for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
      compare(*judge, *engine, arguments[i], compile_default_view(model_path(arguments[i]), setup, projection).program);
    }
  }
}

}  // namespace

}  // namespace csgsim::testing

int main(int argc, char** argv) {
  try {
    csgsim::testing::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
