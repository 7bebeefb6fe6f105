#pragma once

#include <array>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::budgets {

/// Path of tests/budgets/NAME in the source tree.
std::string source_path(const std::string& name);

/// A run at the functional level on Pixel-planes 4; an overflowing linear expression fails the test.
struct Measured {
  observe::Stats stats;
  observe::Frame frame;
};
Measured measure(const isa::Program& program);

/// Clocks that the controller spends on the most expensive primitive, without the trees' latency.
std::uint64_t max_primitive_clocks(const observe::Stats& stats);

/// Clocks of all instructions divided by the number of those with a linear expression.
double clocks_per_expression(const observe::Stats& stats);

/// A corner of a triangle in the Programs; x to the right, y down and z away from the eye in pixels, components 0 to
/// 255.
struct Corner {
  double x, y, z;
  std::array<double, 3> colour;
};
using Triangle = std::array<Corner, 3>;

/// The linear interpolation at (x, y) of the values at the corners.
double interpolate(const Triangle& triangle, const std::array<double, 3>& values, double x, double y);

/// Barycentric coordinates of the point (x, y): three weights that sum to 1, all positive inside.
std::array<double, 3> barycentric_coordinates(const Triangle& triangle, double x, double y);

}  // namespace csgsim::budgets
