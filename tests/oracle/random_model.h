#pragma once

#include <cstdint>
#include <string>

namespace csgsim::testing {

/// A random CSG model of boxes, cylinders, cones and balls on a coarse grid, so that many faces coincide, under one
/// random rotation; as OpenSCAD would print it. The same seed gives the same model everywhere.
std::string random_model(std::uint64_t seed, unsigned primitives);

}  // namespace csgsim::testing
