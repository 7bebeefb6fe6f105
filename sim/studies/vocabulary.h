#pragma once

#include <string_view>
#include <vector>

#include "sim/report/points.h"

namespace csgsim::studies {

/// The columns of a table that a page shows, in their order, with what they are called there: those of the vocabulary.
std::vector<report::PointColumn> page_columns(std::string_view header);

}  // namespace csgsim::studies
