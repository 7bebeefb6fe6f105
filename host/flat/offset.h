#pragma once

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// What stands at an outer corner of the area that is offset.
enum class Corner : std::uint8_t {
  round,  ///< an arc: offset(r = ...)
  sharp,  ///< the sides drawn out: offset(delta = ...)
  cut     ///< a side across: offset(delta = ..., chamfer = true)
};

/// The area grown by a distance, or shrunk by a negative one, in units of 2^-16, as OpenSCAD has it. The facets count
/// for round corners alone. Throws InputError for coordinates that are too large, and for too many corners, and
/// WorkError past the limit on work.
Area offset(const Area& area, double distance, Corner corner, const model::FacetControl& facets, const Work& work = {});

}  // namespace csgsim::flat
