#include "host/setup/camera.h"

#include "host/read/read.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr machines::Size picture{64, 48};
const model::Tree tree = read::read_csg_text("cube(size = 10, center = true);", "m.csg");
const facet::Geometry scene = facet::make_geometry(tree);

view::Camera camera_for(const setup::CameraChoice& choice) { return setup::camera_for(choice, picture, tree, scene); }

}  // namespace

TEST_CASE("a given camera replaces eye and centre of the scene but not the projection") {
  setup::CameraChoice choice{.given = view::Camera{{1, 2, 3}, {4, 5, 6}}, .projection = view::Projection::perspective};
  choice.eye = glm::dvec3(7);
  const view::Camera camera = camera_for(choice);
  CHECK(camera.eye == glm::dvec3(1, 2, 3));
  CHECK(camera.centre == glm::dvec3(4, 5, 6));
  CHECK(camera.projection == view::Projection::perspective);
}

TEST_CASE("without a camera the view shows the whole model from OpenSCAD's direction") {
  const view::Camera camera = camera_for({});
  const view::Camera usual = view::default_camera(scene.box, picture.width, picture.height);
  CHECK(camera.eye == usual.eye);
  CHECK(camera.centre == usual.centre);
}

TEST_CASE("eye and centre of the scene replace those of the default view one by one") {
  setup::CameraChoice choice;
  choice.eye = glm::dvec3(0, -50, 0);
  const view::Camera camera = camera_for(choice);
  CHECK(camera.eye == glm::dvec3(0, -50, 0));
  CHECK(camera.centre == camera_for({}).centre);
}

TEST_CASE("view-all keeps a given camera's direction and moves the camera to fit the model") {
  setup::CameraChoice choice{.given = view::Camera{{0, -500, 0}, {0, 0, 0}}, .shows_all = true};
  const view::Camera camera = camera_for(choice);
  const view::Camera fitted = view::view_all(*choice.given, scene.box, picture.width, picture.height);
  CHECK(camera.eye == fitted.eye);
  CHECK(camera.eye.x == doctest::Approx(0));
  CHECK(camera.eye.y > -100);
}
