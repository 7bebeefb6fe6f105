#pragma once

#include <chrono>
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
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/base/work.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// How far facets may be from the curved surface.
struct Tolerance {
  double value = 0;
  bool in_pixels = false;  ///< else in model units
};

/// Of strategy bits; no tree needs as many.
inline constexpr unsigned most_stack_bits = 64;

/// Of the work that reading a model may take, and compiling it: millions of steps (hw/base/work.h).
inline constexpr std::uint32_t usual_limit = 8'000;
inline constexpr std::uint32_t most_limit = 1'000'000'000;

/// Memory bits a pixel where a picture is drawn for its own sake, or what it needs is one of the results.
inline constexpr std::uint32_t ample_memory_bits = 256;

/// Options of every command that compiles a model.
struct ModelRequest {
  std::string model;
  std::string imports_from;
  bool snap = false;  ///< rotations are restored from the digits that are written
  std::uint32_t limit = usual_limit;
  std::optional<std::uint32_t> openscad_seconds;
  std::string machine = "pixel-planes-4";
  std::string size;
  std::optional<std::uint32_t> memory_bits;
  std::string camera;
  std::string projection;  ///< empty: the scene's
  bool view_all = false;
  std::optional<double> near;
  std::string scene_file;
  std::string colour_scheme;      ///< empty: the scene's colours
  std::vector<std::string> sets;  ///< KEY=VALUE of the scene, or of a figure of the machine
  unsigned z_bits = 20;
  unsigned fraction_bits = 12;
  double edge_on = 1.0 / 256;
  std::optional<Tolerance> tolerance;
  std::string curves = "auto";
  std::string strategy = "stack";
  unsigned stack_bits = emit::fewest_stack_bits;
  std::string colouring = "rebroadcast";
  unsigned colour_bits = isa::most_colour_bits;
  std::string pruning = "all";  ///< see pruning_of

  void add_to(OptionList& options,
              const std::string& what =
                  "The model, an OpenSCAD .csg file (- is standard input), its source, .scad, or commands, .jan");

  /// What is seen besides the model's solids; read once. Throws InputError, or UsageError for what was set.
  [[nodiscard]] const scene::Scene& scene() const { return loaded_scene().scene; }
  [[nodiscard]] const std::vector<scene::SectionValues>& scene_values() const { return loaded_scene().values; }
  [[nodiscard]] const std::string& scene_text() const { return loaded_scene().text; }

  /// The same with those effects switched off, whatever the scene or the model calls for.
  [[nodiscard]] ModelRequest without_effects(const std::vector<std::string>& names) const;

  /// That OpenSCAD may take.
  [[nodiscard]] std::chrono::seconds openscad_time() const;

  /// The files that are read: the model, the scene, and the machine if it is one.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;

  /// Of these only what the picture shows and how exactly: nothing that a sweep varies.
  void add_view_to(OptionList& options);

 private:
  struct LoadedScene {
    std::string text;
    scene::Scene scene;
    std::vector<scene::SectionValues> values;  ///< of its keys
  };

  [[nodiscard]] const LoadedScene& loaded_scene() const;

  mutable std::shared_ptr<const LoadedScene> scene_;
  std::vector<std::string> effects_off_;
};

/// What these words of a command line say: the model and options. Throws UsageError.
ModelRequest model_request_in(std::span<const std::string> words);

/// Those of --strategy.
std::vector<std::string> strategy_names();

/// The machine with the array that the options ask for.
machines::Machine machine_of(const ModelRequest& request);

/// A tolerance in pixels is turned into model units by what a pixel covers where the model is nearest to the eye, and
/// what was chosen is printed.
facet::Faceting faceting_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree);

/// The same, of what takes facets alone: throws UsageError if --curves asks for curved surfaces.
facet::Faceting flat_faceting_of(const ModelRequest& request, const machines::Machine& machine,
                                 const model::Tree& tree);

/// The primitives, if any, whose quadrics do not fit the machine's numbers as the camera sees them.
std::vector<bool> unfit_primitives(const facet::Geometry& scene, const view::View& view);

view::Sampling sampling_of(const ModelRequest& request, const machines::Machine& machine);
emit::Options emit_options_of(const ModelRequest& request);

/// That reading and compiling the model may take.
Work work_of(const ModelRequest& request);

/// With --view-all, or without a camera, the extent of the model (convex/extent.h) is seen.
view::Camera camera_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree,
                       const facet::Geometry& scene);

}  // namespace csgsim::session
