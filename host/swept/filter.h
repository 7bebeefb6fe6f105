// The thesis's integrity filter for subdivided patches.
// Used by mesh.cpp.
#pragma once

#include "host/swept/element.h"
#include "host/swept/output.h"
#include "host/swept/wire_frame.h"

namespace csgsim::swept {

/// The integrity filter of the thesis (algorithms 3.2 and 3.3). It reads a patch's elements in stream order and stores
/// only those on the border between processed and unprocessed elements. A corner of an element that lies on the side of
/// a larger element is placed on the line between that side's corners, in proportion to its position on the side.
///
/// If those corners move later, because they lie on the side of a still larger element, the corners between them wait
/// for the final positions and so end up on the line.
///
/// If `edges` is not null, the patch's edges follow a wire frame; otherwise the patch shares them with no other patch.
/// Adds the work to the counts, and raises the peak counts to those of this patch where these are higher.
void filter(Stream& stream, const PatchEdges* edges, Output& output, RepairCounts& counts);

}  // namespace csgsim::swept
