#include "sim/studies/dimensions.h"

#include <fmt/format.h>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/session/options/numbers.h"

namespace csgsim::studies {

std::vector<double> tolerances_in(const std::string& text) {
  std::vector<double> tolerances;
  for (const std::string& word : session::parse_words(text)) {
    tolerances.push_back(session::numbers<double>(word, ',', 1, "--tolerances", "0.1,0.05")[0]);
    if (!(tolerances.back() > 0))
      throw InputError(printable(word) + " is no tolerance; take a number of model units above 0");
  }
  return tolerances;
}

std::string strategy_name(const std::string& strategy, unsigned stack_bits) {
  return has_stack_bits(strategy) ? fmt::format("{} {}", strategy, stack_bits) : strategy;
}

}  // namespace csgsim::studies
