#include "tests/unit/software/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "tests/oracle/random_curves.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

namespace {

view::Camera any_camera(Random& random) {
  const view::Projection projection = random.one_of({view::Projection::orthographic, view::Projection::perspective});
  switch (random.below(8)) {
    case 0: return {{0, -60, 0}, {0, 0, 0}, projection};
    case 1: return {{0, 0, 60}, {0, 0, 0}, projection};
    case 2: return {{0.25, -1, 0.5}, {0, 3, 0}, view::Projection::perspective};
    case 3: return {{14, -12, 11}, {0, 0, 0}, projection};
    case 4: return {{14, -20, 15}, {20, -30, 21}, projection};  // the model is behind it
    default: return {{14, -21, 17}, {0, 0, 0}, projection};
  }
}

void draw_size(Random& random, view::Sampling& sampling) {
  sampling.width = random.one_of({1U, 3U, 15U, 16U, 17U, 31U, 33U, 63U, 64U, 65U, 70U});
  sampling.height = random.one_of({1U, 3U, 15U, 16U, 17U, 20U, 33U});
}

void draw_bits(Random& random, view::Sampling& sampling) {
  sampling.z_bits = random.one_of({4U, 5U, 6U, 6U, 8U, 20U});
  sampling.fraction_bits = random.one_of({0U, 0U, 0U, 2U, 12U});
}

/// Several models next to and inside each other, so that parts of one of them remain.
std::string models(Random& random) {
  std::string csg;
  for (std::uint64_t i = 1 + random.below(3); i > 0; --i) {
    const auto primitives = 1 + static_cast<unsigned>(random.below(6));
    const std::uint64_t seed = random.below(1U << 30U);
    csg += random_model(seed, primitives);
  }
  return csg;
}

Scene curved_scene(Random& random) {
  const view::Projection projection = random.one_of({view::Projection::orthographic, view::Projection::perspective});
  CurvedScene curved = random_curves(random.below(1U << 30U), projection);
  if (random.below(2) == 0) draw_size(random, curved.sampling);
  if (random.below(2) == 0) draw_bits(random, curved.sampling);
  return make_scene(read::read_csg_text(curved.csg, "test"), curved.camera, curved.sampling, {.exact_curves = true});
}

/// Boxes with sides between pixels, at borders of cells and of their quarters.
std::string box(Random& random) {
  const auto at = [&](double step, int low) { return step * (low + static_cast<double>(random.below(8))); };
  const double x = at(8, -4);
  const double y = at(4, -4);
  const double z = at(8, -4);
  const double width = at(8, 1);
  const double depth = at(4, 1);
  const double height = at(8, 1);
  return fmt::format(
      "multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{cube(size=[{},{},{}],center=false);}}\n", x, y, z,
      width, depth, height);
}

std::string boxes(Random& random, unsigned levels) {
  if (levels == 0 || random.below(4) == 0) return box(random);
  std::string csg = random.one_of({"union", "union", "difference", "intersection"}) + std::string("(){\n");
  for (std::uint64_t i = 2 + random.below(2); i > 0; --i) csg += boxes(random, levels - 1);
  return csg + "}\n";
}

Scene box_scene(Random& random) {
  view::Sampling sampling;
  sampling.width = random.one_of({32U, 48U, 64U});
  sampling.height = random.one_of({32U, 48U});
  draw_bits(random, sampling);
  // A pixel is one unit or half a unit.
  const double pixels = sampling.height / random.one_of({1.0, 2.0});
  const double distance = pixels / 2 / view::half_height_per_distance();
  const view::Camera camera{{0, -distance, 0}, {0, 0, 0}, view::Projection::orthographic};
  return make_scene(read::read_csg_text(boxes(random, 3), "test"), camera, sampling);
}

Scene any_scene(std::uint64_t seed) {
  Random random(seed);
  const std::uint64_t kind = random.below(6);
  if (kind < 2) return curved_scene(random);
  if (kind == 2) return box_scene(random);
  const view::Camera camera = any_camera(random);
  view::Sampling sampling;
  draw_size(random, sampling);
  draw_bits(random, sampling);
  if (camera.projection == view::Projection::perspective && random.below(2) == 0) {
    sampling.near = random.one_of({0.25, 0.5, 8.0, 30.0});
  }
  return make_scene(read::read_csg_text(models(random), "test"), camera, sampling);
}

}  // namespace

Scene make_scene(model::Tree tree, const view::Camera& camera, const view::Sampling& sampling,
                 facet::Faceting faceting) {
  if (faceting.exact_curves) {
    const facet::Geometry geometry = facet::make_geometry(tree, faceting);
    const view::View view = view::make_view(geometry, tree, camera, sampling);
    for (const facet::Convex& solid : geometry.solids) {
      faceting.faceted.push_back(std::ranges::any_of(solid.quadrics, [&](const facet::QuadricSide& side) {
        return view.quadrics[side.quadric].kind == view::ScreenQuadricKind::unfit;
      }));
    }
  }
  facet::Geometry geometry = facet::make_geometry(tree, faceting);
  view::View view = view::make_view(geometry, tree, camera, sampling);
  return {std::move(tree), std::move(geometry), std::move(view)};
}

std::optional<Scene> random_scene(std::uint64_t seed) {
  try {
    Scene scene = any_scene(seed);
    // The rules are undefined if a plane has no integer form.
    const bool fits = std::ranges::all_of(scene.view.planes, &view::ScreenPlane::representable);
    return fits ? std::optional(std::move(scene)) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Scene thesis_scene(const ThesisObject& object, std::uint32_t width, std::uint32_t height) {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  return make_scene(read::read_csg_file(model_path(object.name)), object.camera, sampling);
}

}  // namespace csgsim::testing
