#pragma once

#include <string>
#include <variant>
#include <vector>

#include "host/flat/area.h"
#include "host/solids/extrusion.h"
#include "tests/agreement/mesh_depth.h"

namespace csgsim::testing {

/// A sweep as OpenSCAD reads it from tests/unit/sweep/data/shapes.scad, and the surface that it makes.
struct Given {
  flat::Area area;
  std::variant<solids::LinearExtrude, solids::RotateExtrude> sweep;
  Mesh surface;
};

Given read_given(const std::string& name);

/// csgsim's pieces of it.
std::vector<model::Polyhedron> swept(const Given& given);

}  // namespace csgsim::testing
