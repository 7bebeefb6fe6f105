#include "tests/lockstep/random_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <random>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::test {

namespace {

struct Ends {
  std::int64_t least;
  std::int64_t most;
};

constexpr std::int64_t max_parameter_clocks = 40;  ///< upper bound of a parameter in clocks

/// Tighter bounds: beyond these, stepping a frame takes too long, or nothing can be drawn.
const std::map<std::string_view, Ends> nearer{
    {"array.width", {1, 12}},
    {"array.height", {1, 12}},
    {"array.memory_bits", {72, 256}},
    {"pixel.memory_bits", {200, 256}},
    {"picture.width", {1, 24}},
    {"picture.height", {1, 24}},
    {"cells.count", {24, 70}},
    {"cells.words", {2, 64}},
    {"cells.word_bits", {20, 62}},
    {"chains.count", {1, 9}},
    {"nodes.columns", {1, 4}},
    {"nodes.rows", {1, 4}},
    {"subdivision.levels", {0, 5}},
    {"renderers.count", {1, 9}},
    {"divider.count", {1, 9}},
    {"processors.count", {1, 9}},
    {"ring.channels", {1, 20}},
    {"divider.memory", {50'000, 4'000'000'000}},
    {"display.memory_words", {500, std::int64_t{1} << 31}},
    {"node.memory_words", {200, std::int64_t{1} << 31}},
    {"node.word_bits", {8, 64}},
    {"chips.count", {1, 4}},
    {"chips.columns", {16, 600}},
    {"chips.rows", {300, 1024}},
    {"timing.refresh_interval", {0, 3000}},
    {"node.instruction_loop_clocks", {1, max_parameter_clocks}},  // 0 clocks have no place in a timeline
    {"node.call_clocks", {1, max_parameter_clocks}},              // the same
};

Ends ends_of(const machines::FigureSchema& figure) {
  const auto known = nearer.find(figure.key);
  if (known != nearer.end())
    return {std::max(figure.least, known->second.least), std::min(figure.most, known->second.most)};
  if (figure.unit == "clocks") return {figure.least, std::min(figure.most, figure.least + max_parameter_clocks)};
  return {figure.least, figure.most};
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  std::int64_t value_of(const machines::FigureSchema& figure) {
    const Ends ends = ends_of(figure);
    if (figure.ideal && one_in(5)) return *figure.ideal;
    if (one_in(4)) return ends.least;
    if (one_in(4)) return ends.most;
    return between(ends);
  }

 private:
  bool one_in(unsigned times) { return random_() % times == 0; }

  /// Each number of bits is equally likely.
  std::int64_t between(const Ends& ends) {
    const auto span = static_cast<std::uint64_t>(ends.most - ends.least);
    const std::uint64_t bits = random_() % (static_cast<std::uint64_t>(std::bit_width(span)) + 1);
    const std::uint64_t place = bits == 0 ? 0 : random_() % (std::uint64_t{1} << bits);
    return ends.least + static_cast<std::int64_t>(std::min(place, span));
  }

  std::mt19937_64 random_;
};

}  // namespace

std::optional<machines::Machine> random_machine(const machines::Kind& kind, std::uint64_t seed) {
  Draw draw(seed);
  machines::Machine machine = machines::blank_machine(kind);
  machine.name = "random";
  for (const machines::FigureSchema& figure : kind.schema) figure.store(machine, draw.value_of(figure));
  // A machine that divides models is tested with models, which need some memory per pixel.
  constexpr std::uint32_t bits_of_models = 200;
  if (machines::division(machine)) machine.array.memory_bits = std::max(machine.array.memory_bits, bits_of_models);
  machine.evaluator_bits = std::min(machine.evaluator_bits, machine.alu_bits);
  try {
    machines::complete(machine);
  } catch (const InputError&) {
    return std::nullopt;
  }
  return machine;
}

std::string figures_of(const machines::Machine& machine) {
  std::string figures;
  for (const machines::FigureSchema& figure : machine.kind->schema)
    figures += fmt::format("{}{}={}", figures.empty() ? "" : " ", figure.key, figure.load(machine));
  return figures;
}

}  // namespace csgsim::test
