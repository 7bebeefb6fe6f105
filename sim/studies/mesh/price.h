#pragma once

#include "hw/processors/processor.h"
#include "sim/software/cost/operations.h"
#include "sim/studies/mesh/measure.h"

namespace csgsim::studies {

/// What a row's counts are in operations of a processor that has no floating point: coordinates are longs, of fixed
/// point. How each count is priced is assumed; docs/reproduction.md has it as a table.
software::Operations subdividing(const MeshRow& row);
software::Operations repairing(const MeshRow& row);

struct MeshSeconds {
  double subdividing = 0;
  double repairing = 0;
};

MeshSeconds seconds_of(const MeshRow& row, const processors::Processor& processor);

}  // namespace csgsim::studies
