#pragma once

#include <cstdint>
#include <string>

namespace csgsim::testing {

/// A random CSG model of boxes, cylinders, cones and balls on a coarse grid, so that many faces coincide, under one
/// random rotation, in OpenSCAD's format. A seed gives the same model on every computer.
std::string random_model(std::uint64_t seed, unsigned primitives);

}  // namespace csgsim::testing
