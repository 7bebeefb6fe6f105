// Rows that hold either results or the reason for a failure.
// Used by studies whose points can fail.
#pragma once

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// Creates the row of a point, which `measure(row)` fills. If that throws InputError, the row holds only the reason.
template <class Row, class Point, class Measure>
Row measured_row(const Point& point, const Inputs& inputs, const Measure& measure) {
  const auto begun = [&] {
    Row row;
    row.point = point;
    row.inputs = inputs;
    return row;
  };
  Row row = begun();
  try {
    measure(row);
  } catch (const InputError& error) {
    row = begun();
    row.reason = escaped(error.what());
  }
  return row;
}

}  // namespace csgsim::studies
