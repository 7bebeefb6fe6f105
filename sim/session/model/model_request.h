// Options of compiling a model, and the values that they stand for.
// Used by sim/app, sim/python, sim/studies, sim/suite and sim/viewer.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/scene/read.h"
#include "host/scene/scene.h"
#include "host/setup/choices.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/base/work.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/scad.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// Upper limit for strategy bits; no tree needs this many.
inline constexpr unsigned max_stack_bits = 64;

/// Limit of the work for reading a model, and again for compiling it, in millions of steps (hw/base/work.h).
inline constexpr std::uint32_t default_work_limit = 8'000;
inline constexpr std::uint32_t max_work_limit = 1'000'000'000;

/// Memory bits per pixel where memory is not the subject: plain pictures, and studies that measure the bits needed.
inline constexpr std::uint32_t ample_memory_bits = 256;

/// Options of every command that compiles a model.
struct ModelRequest {
  std::string model;
  std::string imports_from;  ///< folder to search for imports; empty if none
  bool snap = false;         ///< restore rotations from the printed digits
  std::uint32_t limit = default_work_limit;
  std::optional<std::uint32_t> openscad_seconds;
  std::vector<std::string> defines;  ///< NAME=VALUE of the variables of a source
  std::string parameters;            ///< file of parameter sets of a source
  std::string parameter_set;
  std::string machine = "pixel-planes-4";
  std::string size;
  std::optional<std::uint32_t> memory_bits;
  std::optional<view::Camera> camera;
  std::string projection;  ///< empty: that of the scene
  bool view_all = false;
  std::optional<double> near;
  std::string scene_file;
  std::string colour_scheme;      ///< empty: the scene's colours
  std::vector<std::string> sets;  ///< KEY=VALUE of the scene or of a machine parameter
  unsigned z_bits = 20;
  unsigned fraction_bits = 12;
  double edge_on = 1.0 / 256;
  std::optional<setup::Tolerance> tolerance;
  std::string curves = "auto";
  std::string strategy = "stack";
  unsigned stack_bits = emit::min_stack_bits;
  std::string colouring = "rebroadcast";
  unsigned colour_bits = isa::max_colour_bits;
  std::string pruning = "auto";  ///< see parse_pruning

  /// Adds all options. `what` describes the operand MODEL in help.
  void add_to(
      OptionList& options,
      const std::string& what =
          "The model: OpenSCAD's export .csg (- reads standard input), a source .scad, commands .jan, or a mesh "
          "(.stl, .off, .obj, .ply, .3mf, .amf)");

  /// Everything visible but the model's solids; read once. Throws InputError, or UsageError for an invalid --set.
  [[nodiscard]] const scene::Scene& scene() const { return loaded_scene().scene; }
  [[nodiscard]] const std::vector<scene::SectionValues>& scene_values() const { return loaded_scene().values; }
  [[nodiscard]] const std::string& scene_text() const { return loaded_scene().text; }

  /// A copy with those effects switched off, even if the scene or the model enables them.
  [[nodiscard]] ModelRequest without_effects(const std::vector<std::string>& names) const;

  /// The options to pass to OpenSCAD with a source. Throws UsageError if a file of parameter sets is given without a
  /// set, or a set without a file, and InputError if the file lacks the set.
  [[nodiscard]] ScadOptions scad_options() const;

  /// The files that are read: the model, the scene, the parameter sets, and the machine's file if it has one.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;

  /// Adds only the options of view and accuracy, without those that a sweep varies.
  void add_view_to(OptionList& options);

 private:
  struct LoadedScene {
    std::string text;
    scene::Scene scene;
    std::vector<scene::SectionValues> values;  ///< values of the scene's keys
  };

  [[nodiscard]] const LoadedScene& loaded_scene() const;

  mutable std::shared_ptr<const LoadedScene> scene_;
  std::vector<std::string> effects_off_;
};

/// Parses words of a command line: the model and its options. Throws UsageError.
ModelRequest parse_model_request(std::span<const std::string> words);

/// Names of the strategies.
std::vector<std::string> strategy_names();

/// The requested machine with the requested picture size and memory.
machines::Machine machine_of(const ModelRequest& request);

/// The parts of the request that concern the compiler, apart from the machine, as values. Throws InputError, or
/// UsageError for invalid options.
setup::Choices choices_of(const ModelRequest& request, const machines::Machine& machine);

/// Size, depth bits, accuracy and near plane of the picture. Throws UsageError for invalid options.
view::Sampling sampling_of(const ModelRequest& request, const machines::Machine& machine);
/// Strategy, colouring, colour bits, scene, prunings and work limit. Throws UsageError for invalid options.
emit::Options emit_options_of(const ModelRequest& request);

/// Work limit of reading and of compiling the model.
Work work_of(const ModelRequest& request);

/// The faceting of the model (host/setup/faceting.h).
facet::Faceting faceting_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree);

/// The same for callers that support facets only: throws UsageError if --curves requests curved surfaces.
facet::Faceting flat_faceting_of(const ModelRequest& request, const machines::Machine& machine,
                                 const model::Tree& tree);

/// The camera (host/setup/camera.h).
view::Camera camera_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree,
                       const facet::Geometry& scene);

}  // namespace csgsim::session
