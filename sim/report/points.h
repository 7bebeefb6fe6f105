// Tables of a study's points.
// Used by sim/report and sim/studies.
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

/// The points of a study, one row each, from the list of objects at a JSON pointer into the data. Keys may be nested,
/// as in `segments/clocks`; columns whose key no point has are omitted. The last column has the `reason` of points that
/// could not be measured.
Table points_table(const Json& data, const std::string& pointer, const std::string& caption,
                   std::span<const PointColumn> columns);

/// Whether a study measured the point.
bool is_measured(const Json& point);

}  // namespace csgsim::report
