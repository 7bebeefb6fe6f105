// Column headings of the pages of studies.
// Used by the runner.
#pragma once

#include <string_view>
#include <vector>

#include "sim/report/points.h"

namespace csgsim::studies {

/// The columns of a table that a page shows, in the table's order, with their headings on the page.
std::vector<report::PointColumn> page_columns(std::string_view header);

}  // namespace csgsim::studies
