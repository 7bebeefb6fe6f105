#include <fmt/format.h>

#include <iterator>

#include "sim/waves/view.h"

namespace csgsim::waves {

std::string surfer_view(const Shown& shown) {
  const auto& [recording, windows, marked, waveform, machine] = shown;
  std::string view;
  auto out = std::back_inserter(view);
  fmt::format_to(out, "variable_add {}.clock_number\n", recording.top);
  std::string_view part;
  for (const wave::Tap* const tap : ordered_taps(recording)) {
    if (unit_name(*tap) != part) {
      part = unit_name(*tap);
      fmt::format_to(out, "divider_add {}\n", part);
    }
    fmt::format_to(out, "variable_add {}.{}\n", recording.top, tap->name);
  }
  fmt::format_to(out, "cursor_set {}\ngoto_cursor\n", (marked + 1) * clock_period_ps(machine));
  return view;
}

}  // namespace csgsim::waves
