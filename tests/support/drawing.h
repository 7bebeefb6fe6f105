#pragma once

#include <string>
#include <vector>

#include "host/emit/compile.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/kind.h"
#include "sim/observe/frame.h"

namespace csgsim::testing {

/// A machine with that array.
machines::Machine machine_of(const isa::ArrayShape& array);

/// A model taken all the way to a Program.
struct Compiled {
  model::Tree tree;
  facet::Geometry scene;
  view::View view;
  isa::Program program;
};

struct Setup {
  view::Camera camera;
  view::Sampling sampling;
  std::uint32_t memory_bits = 72;
  emit::Options options{};
  /// What the machine works on at a time: the whole picture, a line, or a square of that many pixels.
  const machines::Kind* kind = &pixel_planes::kind;
  machines::Size square{};
  bool has_global_or = true;
  std::string machine{};  ///< one that comes with csgsim, by name, instead of all that
  /// Curved surfaces without facets, on a machine whose expressions are of degree 2 and whose pixels have
  /// `memory_bits`. Primitives that do not fit it are faceted.
  bool exact_curves = false;
};

Compiled compile_text(const std::string& csg, const Setup& setup);
/// A Program of the same view for another machine or by other options.
isa::Program compile_again(const Compiled& compiled, const Setup& setup);
Compiled compile_file(const std::string& path, const Setup& setup);

/// The whole model from the default direction of view, whatever the camera in `setup`.
Compiled compile_default_view(const std::string& path, Setup setup, view::Projection projection);

/// Runs a Program at the functional level. Throws where a linear expression overflows its width.
observe::Frame draw(const isa::Program& program, unsigned threads = 1);
observe::Frame draw_on(machines::Machine machine, const isa::Program& program, unsigned threads = 1);

/// tests/models/NAME.csg of the source tree.
std::string model_path(const std::string& name);

/// The object of the thesis's fig. 2.3 and our stand-ins for its three test objects, each as its pictures show it.
struct ThesisObject {
  std::string name;
  view::Camera camera;
};
std::vector<ThesisObject> thesis_objects(view::Projection projection);

/// A camera from six numbers, as on the command line.
view::Camera camera(const glm::dvec3& eye, const glm::dvec3& centre, view::Projection projection);

}  // namespace csgsim::testing
