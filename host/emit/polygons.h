#pragma once

#include "host/emit/surface.h"

namespace csgsim::emit {

/// Whether Strategy::polygons draws the surface face by face: nothing is compared with it but its own faces, all are
/// flat and none is cut by the near plane, and flat shading is all that is called for.
bool has_polygons(const Context& context, const PlannedSurface& planned, const Surface& surface);

/// Draws the surface where it is visible: each face for itself where it is nearer than Z2. A face is what its
/// neighbours' planes leave of its own (thesis 7.2.1 and 8.2), by the depths at which machines compare planes, so that
/// each pixel is of the face that emit_surface finds there. A plane that the face nowhere comes near is not compared.
void emit_polygons(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides,
                   const Surface& surface);

}  // namespace csgsim::emit
