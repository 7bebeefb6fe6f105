#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/report/page.h"

namespace csgsim::report {

struct PointColumn {
  const char* key;
  const char* title;
  Show show = Show::plain;
};

/// The points of a study, a row each: the objects of the list at that pointer of the data. Columns whose key no point
/// has are left out. Of a point with a `reason` why it was not measured, that stands in the last column.
Table points_table(const Json& data, const std::string& at, const std::string& caption,
                   std::span<const PointColumn> columns);

/// A value as a word of an axis or a name.
std::string word_of(const Json& value);

/// Whether a study measured the point.
bool is_measured(const Json& point);

/// The values of a key in the order in which they come up.
std::vector<std::string> words_of(std::span<const Json> points, const std::string& key);

/// What of a point stands at an axis, and which line it is of.
struct Curve {
  std::function<double(const Json&)> x;
  std::function<double(const Json&)> y;
  std::function<std::string(const Json&)> line;
  std::function<std::string(const Json&)> label = [](const Json&) { return std::string(); };
};

/// Lines of the points that were measured, in the order in which their names come up. One that would cover an earlier
/// one is counted in that one's name: `(+ 2 alike)`.
std::vector<Series> series_of(std::span<const Json> points, const Curve& curve);

/// The place of a key's value among words, for an axis of words.
std::function<double(const Json&)> place_in(const std::vector<std::string>& words, const std::string& key);

/// A number of a point.
std::function<double(const Json&)> number_at(const std::string& key);

}  // namespace csgsim::report
