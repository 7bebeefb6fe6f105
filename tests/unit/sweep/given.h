#pragma once

#include <string>
#include <variant>
#include <vector>

#include "host/flat/area.h"
#include "host/solids/extrusion.h"
#include "tests/agreement/mesh_depth.h"

namespace csgsim::testing {

/// A sweep as OpenSCAD evaluates it from tests/unit/sweep/data/shapes.scad, and its surface.
struct Given {
  flat::Area area;
  std::variant<solids::LinearExtrude, solids::RotateExtrude> sweep;
  Mesh surface;
};

Given read_given(const std::string& name);

/// Returns csgsim's pieces of the sweep.
std::vector<model::Polyhedron> swept(const Given& given);

}  // namespace csgsim::testing
