#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// What series and parts are painted with. The colours are near those of Okabe and Ito, moved apart until every two
/// differ to people who see all colours, to those without red or green cones, and in grey; a test works it out.
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

/// How a series looks. Each has a colour, a dash and a mark of its own.
struct Look {
  std::string_view colour;
  std::string_view dash;  ///< half pixels drawn and left out in turn; empty where the line is whole
  Mark mark;
};

inline constexpr std::array looks{
    Look{"#006ead", "", Mark::disc},         Look{"#e49d00", "16,6", Mark::square},
    Look{"#910a00", "8,5", Mark::up},        Look{"#3ba4d8", "3,4", Mark::diamond},
    Look{"#008a60", "18,4,3,4", Mark::down}, Look{"#000000", "12,4,3,4,3,4", Mark::ring},
    Look{"#cb679e", "30,8", Mark::pentagon}, Look{"#7e3e73", "3,10", Mark::box},
};
inline constexpr std::size_t most_series = looks.size();

/// The same on a dark page: each near the hue of its look, with black as white.
inline constexpr auto colours_on_dark = std::to_array<std::string_view>(
    {"#4477b7", "#ffcf47", "#ea5f45", "#7bcdf9", "#057455", "#ffffff", "#e19fbe", "#ad8ef4"});
static_assert(colours_on_dark.size() == looks.size());

/// Of what lies below all, of texts and axes, of lines across an area, and of those from labels to their places.
inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view ink = "#000000";
inline constexpr std::string_view grid = "#dddddd";
inline constexpr std::string_view leader = "#666666";

/// Of series that are not in the key, and of those behind the others.
inline constexpr Look background{"#9a9a9a", "", Mark::disc};

/// What parts of bars are filled with; free room is white.
inline constexpr auto fills = std::to_array<std::string_view>(
    {"#00366a", "#89bcde", "#d8914e", "#edcc88", "#111111", "#8b0750", "#308a21", "#e76172", "#735229"});

/// Light, of 0 to 1, that a screen sends for `#rrggbb`, as W3C's contrast counts it.
double luminance(std::string_view colour);

/// Of two colours, 1 to 21, as W3C's accessibility guidelines define it.
double contrast(std::string_view one, std::string_view other);

/// What is better to read on the colour: black or white, though not ink or paper, which a dark page turns round.
std::string_view text_on(std::string_view colour);

}  // namespace csgsim::plots::palette
