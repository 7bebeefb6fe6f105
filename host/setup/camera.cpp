#include "host/setup/camera.h"

#include "host/convex/extent.h"
#include "host/csg/positive_tree.h"

namespace csgsim::setup {

namespace {

bool is_complete(const CameraChoice& choice) { return choice.given || (choice.eye && choice.centre); }

/// The box that the camera shows. It must not depend on how curved surfaces are drawn.
facet::Box shown_box(const CameraChoice& choice, const model::Tree& tree, const facet::Geometry& scene) {
  if (is_complete(choice) && !choice.shows_all) return scene.box;
  const bool has_quadrics = !scene.quadrics.quadrics().empty();
  return has_quadrics ? convex::extent(facet::make_geometry(tree), csg::make_positive_tree(tree))
                      : convex::extent(scene, csg::make_positive_tree(tree));
}

}  // namespace

view::Camera camera_for(const CameraChoice& choice, const machines::Size& picture, const model::Tree& tree,
                        const facet::Geometry& scene) {
  const facet::Box box = shown_box(choice, tree, scene);
  view::Camera camera = view::default_camera(box, picture.width, picture.height);
  camera.eye = choice.eye.value_or(camera.eye);
  camera.centre = choice.centre.value_or(camera.centre);
  if (choice.given) camera = *choice.given;
  camera.projection = choice.projection;
  return choice.shows_all ? view::view_all(camera, box, picture.width, picture.height) : camera;
}

}  // namespace csgsim::setup
