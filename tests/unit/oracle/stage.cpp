#include "tests/unit/oracle/stage.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "host/read/read.h"

namespace csgsim::testing {

Stage::Stage(const std::string& csg, scene::Scene of)
    : scene(std::move(of)),
      tree(read::read_csg_text(csg, "stage")),
      facets(facet::make_geometry(tree)),
      distance_((stage_half + 0.5) / view::half_height_per_distance()) {
  shot.camera = {{0, -distance_, 0}, {0, 0, 0}, view::Projection::orthographic};
  shot.width = 2 * stage_half + 1;
  shot.height = 2 * stage_half + 1;
}

void Stage::cast(const RayEffects& effects, const RayDoubt& doubt) {
  picture_ = ray_picture(tree, facets, scene, shot, effects, doubt);
}

const RayColour& Stage::at(std::int32_t x, std::int32_t z) const {
  const std::int32_t column = stage_half + x;
  const std::int32_t row = stage_half - z;
  return picture_.at(static_cast<std::size_t>(row) * shot.width + static_cast<std::size_t>(column));
}

std::string box(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 size = high - low;
  return fmt::format(
      "multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{cube(size=[{},{},{}],center=false);}}\n", low.x, low.y,
      low.z, size.x, size.y, size.z);
}

std::string with_colour(const glm::dvec3& colour, const std::string& csg) {
  return fmt::format("color([{},{},{},1]){{{}}}\n", colour.x, colour.y, colour.z, csg);
}

scene::Scene plain_colours() {
  scene::Scene scene;
  scene.ambient.intensity = 1;
  scene.lights.push_back(white_light({0, 1, 0}));
  scene.lights.front().intensity = 0;
  scene.background.colour = glm::dvec3(0);
  return scene;
}

scene::Light white_light(const glm::dvec3& direction) {
  scene::Light light;
  light.direction = direction;
  return light;
}

scene::Scene scene_with_light(const scene::Light& light) {
  scene::Scene scene;
  scene.lights.push_back(light);
  return scene;
}

bool is_near(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-9; }

}  // namespace csgsim::testing
