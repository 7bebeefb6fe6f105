#include "tests/unit/effects/effect_picture.h"

#include <fmt/format.h>

#include "host/effects/rows.h"
#include "host/scene/read.h"

namespace csgsim::testing {

scene::Scene scene_of(const std::string& toml, const std::vector<std::string>& sets) {
  return scene::read_scene(toml, "test.toml", sets, effects::sections());
}

Setup front_view(std::uint32_t width, std::uint32_t height, scene::Scene scene) {
  const glm::dvec3 middle{width / 2.0, 0, -(height / 2.0)};
  const double distance = (height / 2.0) / view::half_height_per_distance();
  Setup setup{{middle - glm::dvec3(0, distance, 0), middle, view::Projection::orthographic}, {}, 256};
  setup.sampling.width = width;
  setup.sampling.height = height;
  setup.options.scene = std::move(scene);
  setup.options.effects = effects::all();
  return setup;
}

std::string box_text(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 size = high - low;
  return fmt::format(
      "multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{cube(size=[{},{},{}],center=false);}}\n", low.x, low.y,
      low.z, size.x, size.y, size.z);
}

std::string tinted(const glm::dvec3& colour, double alpha, const std::string& csg) {
  return fmt::format("color([{},{},{},{}]){{{}}}\n", colour.x, colour.y, colour.z, alpha, csg);
}

}  // namespace csgsim::testing
