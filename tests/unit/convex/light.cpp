#include "tests/unit/convex/light.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace csgsim::testing {

using namespace convex;

double signed_distance(const TestModel& model, const ShadowVolume& volume, const glm::dvec3& point) {
  double highest = -1e300;
  for (const auto* list : {&volume.facing, &volume.edge_on}) {
    for (const facet::Halfspace& halfspace : *list) {
      highest = std::max(highest, signed_distance(model.scene, halfspace, point));
    }
  }
  for (const facet::Plane& plane : volume.silhouette) {
    highest = std::max(highest, glm::dot(plane.normal, point - model.scene.planes.centre()) + plane.offset);
  }
  return highest;
}

glm::dvec3 end_of_segment(const TestModel& model, const Light& light, const glm::dvec3& point) {
  if (light.place.w != 0.0) return glm::dvec3(light.place) / light.place.w;
  return point + 10.0 * model.scene.planes.diagonal() * glm::normalize(glm::dvec3(light.place));
}

Light random_light(const TestModel& model, testing::RandomPoints& random) {
  switch (random.below(4)) {
    case 0: {
      // Along an axis, which makes many faces edge-on.
      glm::dvec4 place(0);
      place[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -2.5;
      return {place};
    }
    case 1: return {glm::dvec4(random.direction(), 0)};
    case 2: return {glm::dvec4(random.around(model.scene.solids.front().box), 1)};
    default: {
      const glm::dvec3 far = model.scene.planes.centre() + 3.0 * model.scene.planes.diagonal() * random.direction();
      return {glm::dvec4(2.0 * far, 2)};
    }
  }
}

}  // namespace csgsim::testing
