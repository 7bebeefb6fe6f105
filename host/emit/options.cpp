#include "host/emit/options.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "host/emit/strategy.h"

namespace csgsim::emit {

#define CSGSIM_DECLARED(name) extern const StrategyRow name##_strategy;
CSGSIM_STRATEGIES(CSGSIM_DECLARED)
#undef CSGSIM_DECLARED

namespace {

#define CSGSIM_ROW(name) &name##_strategy,
constexpr std::array strategy_rows{CSGSIM_STRATEGIES(CSGSIM_ROW)};
#undef CSGSIM_ROW
#define CSGSIM_NAME(name) #name,
constexpr auto strategy_names = std::to_array<std::string_view>({CSGSIM_STRATEGIES(CSGSIM_NAME) "auto"});
#undef CSGSIM_NAME
constexpr auto colouring_names = std::to_array<std::string_view>({"rebroadcast", "field", "auto"});
static_assert(colouring_names.size() == colourings.size());

}  // namespace

std::string_view name_of(Strategy strategy) { return strategy_names.at(static_cast<std::size_t>(strategy)); }
std::string_view name_of(Colouring colouring) { return colouring_names.at(static_cast<std::size_t>(colouring)); }

const StrategyRow& row_of(Strategy strategy) {
  if (strategy == Strategy::automatic) throw std::logic_error("no strategy was chosen");
  return *strategy_rows.at(static_cast<std::size_t>(strategy));
}

std::vector<Strategy> default_strategies() {
  std::vector<Strategy> usual;
  for (const Strategy strategy : strategies)
    if (strategy != Strategy::automatic && row_of(strategy).is_usual) usual.push_back(strategy);
  return usual;
}

Options with_prices(Options options, const machines::Machine& machine) {
  if (options.prices_on != nullptr) options.prices = options.prices_on(machine);
  options.prices_on = nullptr;
  return options;
}

csg::Pruning pruning_of(const Options& options) {
  csg::Pruning pruning = options.pruning;
  if (options.strategy != Strategy::automatic && !row_of(options.strategy).takes_sets) pruning.sets = false;
  return pruning;
}

}  // namespace csgsim::emit
