#pragma once

#include <span>
#include <string>

#include "sim/report/page.h"

namespace csgsim::report {

struct PointColumn {
  const char* key;
  const char* title;
  Show show = Show::plain;
};

/// The points of a study, a row each: the objects of the list at that pointer of the data. Keys may be of objects
/// within, `segments/clocks`; columns whose key no point has are left out. Of a point with a `reason` why it was not
/// measured, that stands in the last column.
Table points_table(const Json& data, const std::string& at, const std::string& caption,
                   std::span<const PointColumn> columns);

/// Whether a study measured the point.
bool is_measured(const Json& point);

}  // namespace csgsim::report
