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

/// Machine with the given array.
machines::Machine machine_of(const isa::ArrayShape& array);

/// Model together with each intermediate result of its compilation to a Program.
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
  /// Area that the machine processes at once: the whole picture, a line, or a square of the given size in pixels.
  const machines::Kind* kind = &pixel_planes::kind;
  machines::Size square{};
  bool has_global_or = true;
  std::string machine{};  ///< name of a machine shipped with csgsim; replaces the settings above
  /// Exact curved surfaces on a machine with degree-2 expressions and `memory_bits` per pixel. Primitives that do not
  /// fit are faceted.
  bool exact_curves = false;
};

Compiled compile_text(const std::string& csg, const Setup& setup);
/// Compiles the same view for another machine or with other options.
isa::Program compile_again(const Compiled& compiled, const Setup& setup);
Compiled compile_file(const std::string& path, const Setup& setup);

/// Shows the whole model from the default direction of view and ignores the camera in `setup`.
Compiled compile_default_view(const std::string& path, Setup setup, view::Projection projection);

/// Runs a Program at the functional level. Throws if a linear expression overflows its width.
observe::Frame draw(const isa::Program& program, unsigned threads = 1);
observe::Frame draw_on(machines::Machine machine, const isa::Program& program, unsigned threads = 1);

/// Path of tests/models/NAME.csg in the source tree.
std::string model_path(const std::string& name);

/// The object of the thesis's fig. 2.3 and our stand-ins for its three test objects, each with the view of its picture.
struct ThesisObject {
  std::string name;
  view::Camera camera;
};
std::vector<ThesisObject> thesis_objects(view::Projection projection);

/// Builds a camera from six numbers, as on the command line.
view::Camera camera(const glm::dvec3& eye, const glm::dvec3& centre, view::Projection projection);

}  // namespace csgsim::testing
