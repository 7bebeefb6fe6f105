#include "sim/report/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace csgsim::report {

std::string grouped(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string number_text(double value) {
  constexpr double most_whole = 9007199254740992.0;  // doubles up to 2^53 tell all whole numbers apart
  constexpr double least_of_five_digits = 9999.5;
  const double size = std::fabs(value);
  if (!std::isfinite(value) || size > most_whole) return fmt::format("{:.4g}", value);
  if (size >= least_of_five_digits || size == std::floor(size))
    return (value < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(std::llround(size)));
  return fmt::format("{:.4g}", value);
}

std::string percent_text(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

}  // namespace csgsim::report
