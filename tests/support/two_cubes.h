#pragma once

#include "host/emit/compile.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"

namespace csgsim::testing {

/// A cube with a notch, seen by a camera that looks at `centre`, in the machine's picture.
inline isa::Program two_cubes(const machines::Machine& machine, const glm::dvec3& centre,
                              const emit::Options& options = {}) {
  const model::Tree tree = read::read_csg_text(
      "difference() { cube(size = [4, 4, 4], center = false);"
      "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 2], [0, 0, 0, 1]]) {"
      "cube(size = [4, 4, 4], center = false); } }",
      "cubes");
  const facet::Geometry scene = facet::make_geometry(tree);
  view::Sampling sampling;
  sampling.width = machine.picture.width;
  sampling.height = machine.picture.height;
  const view::View view =
      view::make_view(scene, tree, {{20, -30, 25}, centre, view::Projection::orthographic}, sampling);
  return emit::compile(tree, scene, view, machine, options);
}

}  // namespace csgsim::testing
