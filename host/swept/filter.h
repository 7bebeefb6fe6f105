#pragma once

#include "host/swept/element.h"
#include "host/swept/output.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// The integrity filter of the thesis (algorithms 3.2 and 3.3): takes a patch's elements in the order of the stream and
/// holds those that the border between what has come and what has not runs along, no others. A corner of an element
/// that is on the side of a larger one is put on the line between that side's corners, at its part of the side.
///
/// Where those corners move later, since they are on the side of a still larger element, what is put between them waits
/// for that, so that it is on the line in the end.
///
/// With `edges` the patch's edges are as a wire frame has them; without, they are of no other patch.
/// Adds to the counts of work, and raises those of what is held to its own.
void filter(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts);

}  // namespace csgsim::swept
