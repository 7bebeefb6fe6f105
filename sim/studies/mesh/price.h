// Prices of meshing.
// Used by csgsim mesh.
#pragma once

#include "hw/processors/processor.h"
#include "sim/software/cost/operations.h"
#include "sim/studies/mesh/measure.h"

namespace csgsim::studies {

/// Converts a row's counts to operations of a processor without floating point; coordinates are 32-bit fixed-point
/// numbers. The operations per count are assumptions, listed in docs/reproduction.md.
software::Operations subdivision_operations(const MeshRow& row);
software::Operations repair_operations(const MeshRow& row);

struct MeshSeconds {
  double subdividing = 0;
  double repairing = 0;
};

MeshSeconds seconds_of(const MeshRow& row, const processors::Processor& processor);

}  // namespace csgsim::studies
