// Mesh repair with a complete quadtree, as an alternative to the filter.
// Used by mesh.cpp.
#pragma once

#include "host/swept/element.h"
#include "host/swept/output.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// The alternative to the filter. It keeps the whole quadtree of the patch, with parents and children, and finds the
/// neighbours of each element in it (Carlson 1982; Samet's method via the nearest common ancestor). It produces the
/// same mesh. `most_elements` counts all elements, `most_edges` all nodes, `edges_visited` the nodes visited in
/// neighbour searches.
void repair_by_quadtree(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts);

}  // namespace csgsim::swept
