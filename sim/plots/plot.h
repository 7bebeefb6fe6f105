// Content of a plot as plain data.
// Used by sim/report and sim/studies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

/// Data of a plot: a study fills it, layout.h computes positions, svg.h and gnuplot.h draw it. Texts may hold any
/// bytes; unprintable ones are shown escaped, and long texts are shortened.
namespace csgsim::plots {

/// A labelled position on an axis.
struct Tick {
  double value = 0;
  std::string text;

  bool operator==(const Tick&) const = default;
};

enum class Scale : std::uint8_t {
  by_range,  ///< logarithmic if the positive values span a factor of 20 or more and none is negative, otherwise linear
  linear,    ///< evenly spaced
  logarithmic,  ///< 0 has a separate tick below the smallest positive value; linear if a value is negative
};

struct Axis {
  std::string title;
  Scale scale = Scale::by_range;
  std::vector<Tick> ticks{};  ///< the measured values; if empty, ticks are derived from the range
  bool is_names = false;      ///< the ticks are names at 0, 1, 2, ...
  bool is_whole = false;      ///< values are whole numbers
};

/// A point of a series. Points with a coordinate that is not finite are omitted.
struct Point {
  double x = 0;
  double y = 0;
  std::string label{};  ///< written next to the point if it fits
};

enum class Trace : std::uint8_t {
  line,     ///< points joined by lines
  steps,    ///< each point's value holds until the next point; the last one's to the edge of the panel
  marks,    ///< points without lines
  level,    ///< horizontal line across the panel at the first point
  upright,  ///< vertical line across the panel at the first point
};

/// Points that belong together. Series with the same name look the same and share an entry in the key.
struct Series {
  std::string name;
  std::size_t panel = 0;
  Trace trace = Trace::line;
  std::vector<Point> points{};
  bool is_background = false;  ///< grey, behind the others
};

/// Indices into `palette::looks` by series name.
using Looks = std::map<std::string, std::size_t>;

/// Panels stacked over one x axis. At most `palette::max_series` names have colours and an entry in the key: those
/// with the largest values in the first panel that has them. The others are grey; the key gives their number and the
/// file with their values. For charts that belong together (common_looks.h), `looks` gives the colours.
struct Chart {
  std::string title;
  Axis x;
  std::vector<Axis> panels;
  std::vector<Series> series;
  std::string table;  ///< name of the file with all values
  Looks looks{};
};

/// A section of a bar.
struct Part {
  std::string name;
  double begin = 0;
  double end = 0;
};

struct Bar {
  std::string name;
  double length = 0;  ///< sections that no part covers stay white
  std::vector<Part> parts{};
};

/// Horizontal bars that start at 0, or extend from 0 to both sides. The first `max_bars` are drawn; the key gives the
/// number of the others.
struct Bars {
  std::string title;
  Axis x;
  std::vector<Bar> bars;
  std::vector<std::string> names;  ///< names of parts in the order of the key; names missing here come last
  std::string table;               ///< name of the file with all values
  bool is_signed = false;          ///< parts extend from 0 to the left or to the right, and no bar has free sections
};
inline constexpr std::size_t max_bars = 40;

/// A plot and the base name of its files, without extension.
struct Plot {
  std::string name;
  std::variant<Chart, Bars> content;
};

}  // namespace csgsim::plots
