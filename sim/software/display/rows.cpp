#include "sim/software/display/rows.h"

#include <algorithm>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "sim/software/methods/rows.h"

namespace csgsim::software {

const DisplayRow& display_method(const std::string& name) {
  const std::span<const DisplayRow* const> rows = display_methods();
  const auto place = std::ranges::find_if(rows, [&](const DisplayRow* row) { return row->name == name; });
  if (place == rows.end()) throw InputError(unknown_name_text("method", name, row_names(rows)));
  return **place;
}

}  // namespace csgsim::software
