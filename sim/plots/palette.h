// Colours, dashes and marks of plots.
// Used by sim/report.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// Colours of series and parts. They are close to those of Okabe and Ito, adjusted until every two are distinguishable
/// with normal vision, with red or green colour blindness, and in grey; a test computes this.
namespace csgsim::plots::palette {

/// Forms of marks, by gnuplot's numbers.
enum class Mark : std::uint8_t {
  disc = 7,
  square = 5,
  up = 9,
  down = 11,
  diamond = 13,
  pentagon = 15,
  ring = 6,
  box = 4
};

/// Colour, dash and mark of a series. No two looks share one of them.
struct Look {
  std::string_view colour;
  std::string_view dash;  ///< lengths of dashes and gaps in half pixels, alternating; empty for a solid line
  Mark mark;
};

inline constexpr std::array looks{
    Look{"#006ead", "", Mark::disc},         Look{"#e49d00", "16,6", Mark::square},
    Look{"#910a00", "8,5", Mark::up},        Look{"#3ba4d8", "3,4", Mark::diamond},
    Look{"#008a60", "18,4,3,4", Mark::down}, Look{"#000000", "12,4,3,4,3,4", Mark::ring},
    Look{"#cb679e", "30,8", Mark::pentagon}, Look{"#7e3e73", "3,10", Mark::box},
};
inline constexpr std::size_t max_series = looks.size();

/// Colours on a dark page: each close to the hue of its look, with white in place of black.
inline constexpr auto colours_on_dark = std::to_array<std::string_view>(
    {"#4477b7", "#ffcf47", "#ea5f45", "#7bcdf9", "#057455", "#ffffff", "#e19fbe", "#ad8ef4"});
static_assert(colours_on_dark.size() == looks.size());

/// Colours of the background, of texts and axes, of grid lines, and of leader lines to labels.
inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view ink = "#000000";
inline constexpr std::string_view grid = "#dddddd";
inline constexpr std::string_view leader = "#666666";

/// Look of series that are not in the key, and of background series.
inline constexpr Look background{"#9a9a9a", "", Mark::disc};

/// Fills of parts of bars. The rest of a bar is white.
inline constexpr auto fills = std::to_array<std::string_view>(
    {"#00366a", "#89bcde", "#d8914e", "#edcc88", "#111111", "#8b0750", "#308a21", "#e76172", "#735229"});

/// Relative luminance of `#rrggbb`, 0 to 1, as defined by the W3C.
double luminance(std::string_view colour);

/// Contrast ratio of two colours, 1 to 21, as defined by W3C's accessibility guidelines.
double contrast(std::string_view one, std::string_view other);

/// The more readable text colour on `colour`: near black or near white, distinct from ink and paper, which a dark page
/// swaps.
std::string_view readable_text_colour(std::string_view colour);

}  // namespace csgsim::plots::palette
