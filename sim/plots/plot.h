#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

/// What a plot shows, as plain data: a study makes it, layout.h finds a place for everything, svg.h and gnuplot.h draw
/// it.
/// Texts may be any bytes; what is not printable is shown escaped, what is too long shortened.
namespace csgsim::plots {

/// A place on an axis with a name of its own.
struct Tick {
  double value = 0;
  std::string text;

  bool operator==(const Tick&) const = default;
};

enum class Scale : std::uint8_t {
  by_range,     ///< logarithmic where positive values range over a factor of 20 and none is negative, linear otherwise
  linear,       ///< evenly spaced
  logarithmic,  ///< 0 stands below the least positive value, at a tick of its own; linear where a value is negative
};

struct Axis {
  std::string title;
  Scale scale = Scale::by_range;
  std::vector<Tick> ticks{};  ///< the values that were measured; none where the range says which
  bool is_names = false;      ///< the ticks are names at 0, 1, 2, ...
  bool is_whole = false;      ///< values are whole numbers
};

/// A value; points with a coordinate that is not finite are left out.
struct Point {
  double x = 0;
  double y = 0;
  std::string label{};  ///< written beside it, where there is room
};

enum class Trace : std::uint8_t {
  line,     ///< the points joined
  steps,    ///< each point's height holds until the next point, that of the last to the panel's edge
  marks,    ///< the points alone
  level,    ///< a height for all of the x axis: that of the first point
  upright,  ///< a place for all of the panel's height: that of the first point
};

/// Points that belong together. Series of one name look alike, and have one entry in the key.
struct Series {
  std::string name;
  std::size_t panel = 0;
  Trace trace = Trace::line;
  std::vector<Point> points{};
  bool is_background = false;  ///< grey, behind the others
};

/// Places in `palette::looks` of names of series.
using Looks = std::map<std::string, std::size_t>;

/// Panels one above the other, over one x axis. At most `palette::most_series` names are in colours and in the key:
/// those with the largest values in the first panel that they are in; the others are grey, and the key says how many,
/// and where they are told. Of charts that belong together (common_looks.h) `looks` says which names are in colours.
struct Chart {
  std::string title;
  Axis x;
  std::vector<Axis> panels;
  std::vector<Series> series;
  std::string table;  ///< file that has all of it
  Looks looks{};
};

/// A stretch of a bar.
struct Part {
  std::string name;
  double begin = 0;
  double end = 0;
};

struct Bar {
  std::string name;
  double length = 0;  ///< what no part covers is free
  std::vector<Part> parts{};
};

/// Bars that lie one below the other, from 0 on; the first `most_bars` of them, with the number of the others.
struct Bars {
  std::string title;
  Axis x;
  std::vector<Bar> bars;
  std::vector<std::string> names;  ///< of parts, in the order of the key; others follow
  std::string table;               ///< file that has all of it
};
inline constexpr std::size_t most_bars = 40;

/// A plot and the name of its files, without their endings.
struct Plot {
  std::string name;
  std::variant<Chart, Bars> content;
};

}  // namespace csgsim::plots
