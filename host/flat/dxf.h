#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

struct DxfOptions {
  std::string layer{};   ///< what alone is drawn; all layers if empty
  glm::dvec2 origin{0};  ///< where in the drawing the origin is
  double scale = 1;      ///< model units of a unit of the drawing
  model::FacetControl facets{};
  Work work{};
};

/// What OpenSCAD 2021.01 makes of an ASCII DXF file: lines, polylines, circles, arcs, ellipses and inserted blocks, cut
/// into segments whose ends are joined where they are within 1/1024. What an odd number of the outlines hold is drawn.
/// Open ones are closed; bulges of polylines are straight. Other entities are left out. Throws InputError, with
/// the line in the file, for what is not DXF.
Area read_dxf(std::string_view bytes, const DxfOptions& options);

}  // namespace csgsim::flat
