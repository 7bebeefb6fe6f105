#include "sim/report/number_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "hw/base/text.h"

namespace csgsim::report {

std::string number_text(double value) {
  constexpr double most_whole = 9007199254740992.0;  // doubles up to 2^53 tell all whole numbers apart
  constexpr double least_in_groups = 999.5;
  const double size = std::fabs(value);
  if (!std::isfinite(value) || size > most_whole) return fmt::format("{:.4g}", value);
  if (size >= least_in_groups || size == std::floor(size))
    return (value < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(std::llround(size)));
  return fmt::format("{:.4g}", value);
}

std::string percent_text(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

}  // namespace csgsim::report
