#pragma once

#include <string>
#include <string_view>

#include "sim/report/page.h"

namespace csgsim::report {

/// A table in a box of its own, which scrolls where the window is too narrow. A cell whose value the page's data hold
/// says where, in data-at. `more` are attributes of the rows, one a row, or none.
std::string table_html(const Table& table, const std::vector<std::string>& more = {});

}  // namespace csgsim::report
