#include "sim/studies/dimensions.h"

#include <algorithm>

#include "host/emit/strategy.h"
#include "hw/base/error.h"
#include "sim/session/options/numbers.h"

namespace csgsim::studies {

bool has_stack_bits(std::string_view strategy_name) {
  return std::ranges::any_of(emit::strategies, [&](emit::Strategy one) {
    return one != emit::Strategy::automatic && strategy_name == emit::name_of(one) && emit::row_of(one).has_stack_bits;
  });
}

std::vector<double> parse_tolerances(const std::string& text) {
  std::vector<double> tolerances;
  for (const std::string& word : session::parse_words(text)) {
    tolerances.push_back(session::numbers<double>(word, ',', 1, "--tolerances", "0.1,0.05")[0]);
    if (!(tolerances.back() > 0)) throw InputError(word + " is not a tolerance; use a positive number of model units");
  }
  return tolerances;
}

std::vector<std::string> without_duplicates(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (std::ranges::find(once, name) == once.end()) once.push_back(name);
  }
  return once;
}

}  // namespace csgsim::studies
