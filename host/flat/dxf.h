// Reader of DXF drawings.
// Used by host/read.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::flat {

struct DxfOptions {
  std::string layer{};   ///< layer to draw; all layers if empty
  glm::dvec2 origin{0};  ///< point of the drawing that becomes the origin
  double scale = 1;      ///< model units per unit of the drawing
  model::FacetControl facets{};
  Work work{};
};

/// Reads an ASCII DXF file as OpenSCAD 2021.01 does: lines, polylines, circles, arcs, ellipses and inserted blocks are
/// cut into segments, whose ends are joined within 1/1024. The result covers the points inside an odd number of
/// outlines. Open outlines are closed; bulges of polylines are treated as straight. Other entities are ignored. Throws
/// InputError with the line number for anything that is not valid DXF.
Area read_dxf(std::string_view bytes, const DxfOptions& options);

}  // namespace csgsim::flat
