#include "sim/session/model/compiled_model.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "host/commands/read.h"
#include "host/effects/rows.h"
#include "host/effects/transparency.h"
#include "host/emit/compile.h"
#include "host/emit/effect.h"
#include "host/emit/no_room.h"
#include "host/read/read.h"
#include "host/read/source.h"
#include "host/setup/camera.h"
#include "host/setup/faceting.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/functional/clocks.h"
#include "sim/session/model/scad.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"

namespace csgsim::session {

namespace {

/// The kind of model; throws InputError for a Program.
Subject model_subject(const ModelRequest& request) {
  const Subject subject = detect_input_kind(request.model);
  if (subject == Subject::program)
    throw InputError(request.model + ": that is a Program; use csgsim run " + shell_word(request.model));
  if (!request.imports_from.empty() && !std::filesystem::is_directory(request.imports_from))
    throw InputError(
        fmt::format("--imports-from: {} is not a folder; name the folder of the imports", request.imports_from));
  return subject;
}

/// Calls a reader of the model. Errors of a file without the name of a model suggest that it may be no model.
template <class Read>
ModelFile read_as_model(const ModelRequest& request, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    const bool may_be_model = request.model == standard_stream || has_model_name(request.model);
    if (may_be_model || message.find(": expected ") == message.npos) throw;
    throw InputError(fmt::format("{}; is this a model? {}", message, model_endings()));
  }
}

/// Rejects options of OpenSCAD for a model that it does not evaluate.
void refuse_scad_options(const ModelRequest& request, Subject subject) {
  if (subject == Subject::scad) return;
  const std::string why =
      fmt::format("{} has no variables to set, only a .scad source has; leave it out", shown_name(request.model));
  if (!request.defines.empty()) throw UsageError("--define", why);
  if (!request.parameters.empty()) throw UsageError("--parameters", why);
  if (!request.parameter_set.empty()) throw UsageError("--parameter-set", why);
}

/// The text of a model; a source has been evaluated by OpenSCAD. `replacement` is read in place of the file.
std::string text_of(const ModelRequest& request, Subject subject, const std::optional<std::string>& replacement) {
  refuse_scad_options(request, subject);
  if (subject == Subject::scad) return evaluate_scad(request.model, replacement, request.scad_options());
  if (replacement) return *replacement;
  return read_file(request.model, subject == Subject::mesh ? read::mesh_file : read::model_file);
}

model::Tree read_tree(Subject subject, const std::string& text, const std::string& name, const read::Options& how) {
  switch (subject) {
    case Subject::commands: return commands::read_text(text, name, how);
    case Subject::mesh: return read::read_mesh(text, name, how);
    case Subject::scad: return read::read_csg_text(text, name + " (as .csg)", how);
    case Subject::csg:
    case Subject::program: break;
  }
  return read::read_csg_text(text, name, how);
}

/// Reads the model; the hash covers its text, the scene and imported files. A text instead of a mesh is in OpenSCAD's
/// language.
ModelFile read_model_text(const ModelRequest& request, const std::optional<std::string>& replacement) {
  const Subject subject = model_subject(request);
  const std::string text = text_of(request, subject, replacement);
  const std::string name = shown_name(request.model);
  Hash hash;
  hash.add(text);
  hash.add(request.scene_text());
  if (request.snap) hash.add("--snap");
  const read::Options how{request.snap, request.imports_from, [&](std::string_view bytes) { hash.add(bytes); },
                          work_of(request)};
  const Subject kind = replacement && subject == Subject::mesh ? Subject::csg : subject;
  model::Tree tree = read_tree(kind, text, name, how);
  tree.file = name;
  return {effects::reshape_model(std::move(tree), request.scene()), hash.text()};
}

}  // namespace

ModelFile read_model_file(const ModelRequest& request, const std::optional<std::string>& replacement) {
  return with_memory_for("the model " + request.model,
                         [&] { return read_as_model(request, [&] { return read_model_text(request, replacement); }); });
}

model::Tree read_model(const ModelRequest& request) { return read_model_file(request).tree; }

namespace {

CompiledModel with_facets(ModelFile file, setup::Choices choices, const machines::Machine& machine) {
  const model::Tree& tree = file.tree;
  return with_memory_for("the half-spaces of " + tree.file, [&]() -> CompiledModel {
    facet::Geometry scene = facet::make_geometry(tree, setup::faceting_for(choices, machine, tree));
    const view::Camera camera = setup::camera_for(choices.camera, machine.picture, tree, scene);
    return {std::move(file.hash), std::move(file.tree), std::move(choices), std::move(scene), camera, {}};
  });
}

/// Warns if the near plane is so close that few depth steps remain for distant surfaces.
void warn_of_coarse_depth(const view::View& view) {
  if (view.depth_step <= (view.depth.far - view.depth.near) / 4.0) return;
  report_line(fmt::format("warning: one depth step at the far end is {:.3g} model units; move --near away from the eye",
                          view.depth_step));
}

/// Warns, once per message, about the substitute for layers that do not fit into memory.
void warn_of_pattern(const emit::OutOfPixelMemory& layers, const std::string& file, const machines::Machine& machine) {
  static std::mutex mutex;
  static std::set<std::string> reported;
  const std::string line = fmt::format(
      "{}: warning: transparent parts are drawn by a screen-door pattern: layers would need {} memory bits per pixel, "
      "and the machine has {}; use --memory-bits {}, or choose the pattern with --set "
      "effects.transparency.method=screen-door",
      file, layers.needed, machine.array.memory_bits, layers.needed);
  const std::lock_guard lock(mutex);
  if (reported.insert(line).second) report_line(line);
}

/// Uses screen-door transparency where only colours of the model are transparent and memory has no room for layers.
isa::Program compile_with_room(const CompiledModel& model, view::View view, const machines::Machine& machine,
                               csg::KeptResults* kept) {
  emit::Options emit = model.choices.options;
  const view::Camera camera = view.camera;
  const auto compiled = [&](view::View seen) {
    return emit::compile(
        model.tree, model.scene, std::move(seen), machine, emit,
        [&](const isa::Program& one) { return functional::measure_clocks(one, machine); }, kept);
  };
  try {
    return compiled(std::move(view));
  } catch (const emit::OutOfPixelMemory& layers) {
    std::optional<scene::Scene> by_pattern = effects::with_screen_doors(emit.scene);
    if (!by_pattern || emit::find_transparency_effect(emit, model.tree, camera) == nullptr) throw;
    emit.scene = std::move(*by_pattern);
    isa::Program program = compiled(view::make_view(model.scene, model.tree, camera, model.choices.sampling));
    warn_of_pattern(layers, model.tree.file, machine);
    return program;
  }
}

}  // namespace

view::View view_of(const CompiledModel& model) {
  return view::make_view(model.scene, model.tree, model.camera, model.choices.sampling);
}

story::HalfspaceFinder halfspaces_of(const CompiledModel& model) { return {model.tree, model.scene, view_of(model)}; }

isa::Program compile_for_camera(const view::Camera& camera, const CompiledModel& model,
                                const machines::Machine& machine, csg::KeptResults* kept) {
  view::View view = view::make_view(model.scene, model.tree, camera, model.choices.sampling);
  warn_of_coarse_depth(view);
  std::size_t halfspaces = 0;
  for (const facet::Convex& solid : model.scene.solids) halfspaces += solid.halfspaces.size();
  return with_memory([&] { return out_of_memory_message(model.tree.file, halfspaces); },
                     [&] { return compile_with_room(model, std::move(view), machine, kept); });
}

CompiledModel facet_model(const ModelRequest& request, const machines::Machine& machine) {
  ModelFile file = read_model_file(request);
  setup::Choices choices = choices_of(request, machine);
  return with_facets(std::move(file), std::move(choices), machine);
}

CompiledModel compile_model(ModelFile file, setup::Choices choices, const machines::Machine& machine) {
  CompiledModel model = with_facets(std::move(file), std::move(choices), machine);
  model.program = compile_for_camera(model.camera, model, machine);
  return model;
}

CompiledModel compile_model(const ModelRequest& request, const machines::Machine& machine) {
  ModelFile file = read_model_file(request);
  return compile_model(std::move(file), choices_of(request, machine), machine);
}

}  // namespace csgsim::session
