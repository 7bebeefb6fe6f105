#pragma once

#include <array>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::budgets {

/// tests/budgets/NAME of the source tree.
std::string place(const std::string& name);

/// A run at the functional level on Pixel-planes 4, which fails the test if a linear expression overflows.
struct Measured {
  observe::Stats stats;
  observe::Frame frame;
};
Measured measure(const isa::Program& program);

/// Clocks of the dearest primitive: what the controller spends on its instructions, without the trees' latency.
std::uint64_t dearest_primitive(const observe::Stats& stats);

/// Clocks of all instructions over the number of those with a linear expression.
double clocks_an_expression(const observe::Stats& stats);

/// A triangle of the Programs; pixels to the right, down and away from the eye, components 0 to 255.
struct Corner {
  double x, y, z;
  std::array<double, 3> colour;
};
using Triangle = std::array<Corner, 3>;

/// The value at (x, y) of what has these values at the corners and is linear between them.
double between(const Triangle& triangle, const std::array<double, 3>& values, double x, double y);

/// How much of each corner is in the point (x, y): three shares that sum to 1, all positive inside.
std::array<double, 3> shares(const Triangle& triangle, double x, double y);

}  // namespace csgsim::budgets
