#include "sim/software/display/rows.h"

#include <algorithm>
#include <array>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "sim/software/methods/rows.h"

namespace csgsim::software {

extern const DisplayRow depth_lists_row;
extern const DisplayRow depth_peeling_row;
extern const DisplayRow rays_row;
extern const DisplayRow scan_line_row;
extern const DisplayRow list_priority_row;
extern const DisplayRow depth_buffer_row;

namespace {

constexpr std::array display_rows{&depth_lists_row, &list_priority_row, &depth_buffer_row,
                                  &scan_line_row,   &depth_peeling_row, &rays_row};

}  // namespace

std::span<const DisplayRow* const> display_methods() { return display_rows; }

const DisplayRow& display_method(const std::string& name) {
  const auto place = std::ranges::find_if(display_rows, [&](const DisplayRow* row) { return row->name == name; });
  if (place == display_rows.end()) throw InputError(no_such("method", name, names_in(display_rows)));
  return **place;
}

}  // namespace csgsim::software
