#pragma once

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// A row of that point, which `measure(row)` fills; where it throws InputError, nothing but the reason.
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
