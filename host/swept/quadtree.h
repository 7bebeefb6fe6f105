#pragma once

#include "host/swept/element.h"
#include "host/swept/output.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// The rival of the filter: keeps all nodes of the patch's quadtree, with fathers and sons, and finds the neighbours of
/// each element in it (Carlson 1982; Samet's way over the nearest common ancestor). What comes out is the same mesh.
/// `most_elements` is all of them, `most_edges` all nodes, `edges_visited` nodes that are looked at to find neighbours.
void repair_by_quadtree(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts);

}  // namespace csgsim::swept
