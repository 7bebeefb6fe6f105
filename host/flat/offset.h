// OpenSCAD's offset() of 2-D areas.
// Used by host/read.
#pragma once

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// The shape of an offset area's outer corners.
enum class Corner : std::uint8_t {
  round,  ///< an arc: offset(r = ...)
  sharp,  ///< the sides extended until they meet: offset(delta = ...)
  cut     ///< a straight cut: offset(delta = ..., chamfer = true)
};

/// The area grown by a distance, or shrunk if it is negative, in units of 2^-16, as in OpenSCAD. `facets` applies only
/// to round corners. Throws InputError for coordinates that are too large or too many corners, and WorkError if the
/// work limit is exceeded.
Area offset(const Area& area, double distance, Corner corner, const model::FacetControl& facets, const Work& work = {});

}  // namespace csgsim::flat
