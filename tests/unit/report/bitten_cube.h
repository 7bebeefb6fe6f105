#pragma once

#include <string>

#include "tests/support/drawing.h"

namespace csgsim::testing {

/// A cube minus a sphere in 40 x 30 pixels, for a named machine or the default of Setup.
inline Compiled bitten_cube(const std::string& machine = {}) {
  Setup setup;
  setup.camera.eye = {20, -30, 25};
  setup.camera.centre = {0, 0, 0};
  setup.sampling.width = 40;
  setup.sampling.height = 30;
  setup.machine = machine;
  return compile_text(
      "difference() { cube(size = [8, 8, 8], center = true); multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3], "
      "[0, 0, 0, 1]]) { sphere($fn = 8, $fa = 12, $fs = 2, r = 4); } }",
      setup);
}

}  // namespace csgsim::testing
