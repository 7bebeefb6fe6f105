#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "hw/base/text.h"
#include "sim/waves/view.h"

namespace csgsim::waves {

namespace {

constexpr std::uint64_t max_clocks_in_view = 64;
constexpr unsigned window_width = 1900;  // screen pixels
constexpr unsigned names_width = 560;
constexpr unsigned row_height = 23;

/// GTKWave's flags for the display of a signal.
std::string_view flags_of(wave::Show show) {
  constexpr auto flags = std::to_array<std::string_view>({"@28\n", "@24\n", "@22\n", "@820\n"});
  return flags.at(static_cast<std::size_t>(show));
}

/// GTKWave shows 2^-zoom time units in 200 screen pixels.
double zoom_of(std::uint64_t clocks, std::uint64_t period) {
  const auto shown = static_cast<double>(std::min(clocks, max_clocks_in_view) * period);
  return -std::log2(shown * 200.0 / (window_width - names_width));
}

}  // namespace

std::string gtkwave_view(const Shown& shown) {
  const auto& [recording, windows, marked, waveform, machine] = shown;
  const std::uint64_t period = clock_period_ps(machine);
  const wave::Window& first = windows.front();
  std::string view;
  auto out = std::back_inserter(view);
  // A name that would break its line or quotes is omitted; the user names the file on the command line.
  const bool is_plain = printable(waveform) == waveform && waveform.find('"') == std::string::npos;
  if (is_plain) fmt::format_to(out, "[dumpfile] \"{}\"\n", waveform);
  fmt::format_to(out, "[timestart] {}\n[size] {} {}\n[pos] -1 -1\n", (first.begin + 1) * period, window_width,
                 row_height * (recording.taps.size() + 17));
  fmt::format_to(out, "*{:.6f} {}\n", zoom_of(first.end - first.begin, period), (marked + 1) * period);
  fmt::format_to(out, "[sst_expanded] 0\n[sst_width] 0\n[signals_width] {}\n", names_width);
  fmt::format_to(out, "@200\n-{}\n", machine.name);
  fmt::format_to(out, "{}{}.clock\n", flags_of(wave::Show::bits), recording.top);
  fmt::format_to(out, "{}{}.clock_number[63:0]\n", flags_of(wave::Show::number), recording.top);
  std::string_view part;
  for (const wave::Tap* const tap : ordered_taps(recording)) {
    if (unit_name(*tap) != part) {
      part = unit_name(*tap);
      fmt::format_to(out, "@200\n-{}\n", part);
    }
    fmt::format_to(out, "{}{}.{}", flags_of(tap->show), recording.top, tap->name);
    if (tap->width > 1) fmt::format_to(out, "[{}:0]", tap->width - 1);
    view += '\n';
  }
  return view;
}

}  // namespace csgsim::waves
