#include "sim/session/model/compiled_model.h"

#include <fmt/format.h>

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
#include "host/emit/no_room.h"
#include "host/read/read.h"
#include "host/read/source.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/functional/clocks.h"
#include "sim/session/model/scad.h"
#include "sim/session/model/see_through.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/run/memory.h"

namespace csgsim::session {

namespace {

void refuse_other_subjects(const ModelRequest& request) {
  if (is_program(request.model))
    throw InputError(request.model + ": that is a Program; use csgsim run " + shell_word(request.model));
  if (!request.imports_from.empty() && !std::filesystem::is_directory(request.imports_from))
    throw InputError(fmt::format("--imports-from: {} is not a folder; name the folder of the imports",
                                 printable(request.imports_from)));
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

/// Reads the text of a model or of a source that OpenSCAD has evaluated; the hash covers it and the scene.
ModelFile read_text(const ModelRequest& request, Subject subject, const std::string& text) {
  const std::string name = shown_name(request.model);
  Hash hash;
  hash.add(text);
  hash.add(request.scene_text());
  if (request.snap) hash.add("--snap");
  const read::Options how{request.snap, request.imports_from, [&](std::string_view bytes) { hash.add(bytes); },
                          work_of(request)};
  model::Tree tree = subject == Subject::commands
                         ? commands::read_text(text, name, how)
                         : read::read_csg_text(text, subject == Subject::scad ? name + " (as .csg)" : name, how);
  tree.file = name;
  return {effects::reshaped(std::move(tree), request.scene()), hash.text()};
}

}  // namespace

ModelFile read_model_file(const ModelRequest& request) {
  refuse_other_subjects(request);
  return with_memory_for("the model " + request.model, [&] {
    const Subject subject = subject_in(request.model);
    const std::string text = subject == Subject::scad ? evaluate_scad(request.model, request.openscad_time())
                                                      : read_file(request.model, read::model_file);
    return read_as_model(request, [&] { return read_text(request, subject, text); });
  });
}

ModelFile read_model_text(const ModelRequest& request, const std::string& text) {
  refuse_other_subjects(request);
  return with_memory_for("the model " + request.model, [&] {
    const Subject subject = subject_in(request.model);
    return read_text(request, subject,
                     subject == Subject::scad ? evaluate_scad(request.model, text, request.openscad_time()) : text);
  });
}

model::Tree read_model(const ModelRequest& request) { return read_model_file(request).tree; }

namespace {

CompiledModel with_facets(ModelFile file, const ModelRequest& request, const machines::Machine& machine) {
  model::Tree& tree = file.tree;
  facet::Geometry scene = facet::make_geometry(tree, faceting_of(request, machine, tree));
  const view::Camera camera = camera_of(request, machine, tree, scene);
  return {std::move(file.hash), std::move(tree), std::move(scene), camera, {}};
}

/// Warns if the near plane is so close that few depth steps remain for distant surfaces.
void warn_of_coarse_depth(const view::View& view) {
  if (view.depth_step <= (view.depth.far - view.depth.near) / 4.0) return;
  report_line(fmt::format("warning: one depth step at the far end is {:.3g} model units; move --near away from the eye",
                          view.depth_step));
}

/// Warns, once per message, about the substitute for layers that do not fit into memory.
void warn_of_pattern(const emit::NoRoom& layers, const ModelRequest& request, const machines::Machine& machine) {
  static std::mutex mutex;
  static std::set<std::string> reported;
  const std::string line = fmt::format(
      "{}: warning: transparent parts are drawn by a screen-door pattern: layers would need {} memory bits per pixel, "
      "and the machine has {}; use --memory-bits {}, or choose the pattern with --set "
      "effects.transparency.method=screen-door",
      shown_name(request.model), layers.needed, machine.array.memory_bits, layers.needed);
  const std::lock_guard lock(mutex);
  if (reported.insert(line).second) report_line(line);
}

/// Uses screen-door transparency where only colours of the model are transparent and memory has no room for layers.
isa::Program compile_with_room(const CompiledModel& model, const view::Camera& camera, view::View view,
                               const ModelRequest& request, const machines::Machine& machine, csg::KeptResults* kept) {
  emit::Options emit = emit_options_of(request);
  const auto compiled = [&](view::View seen) {
    return emit::compile(
        model.tree, model.scene, std::move(seen), machine, emit,
        [&](const isa::Program& one) { return functional::measure_clocks(one, machine); }, kept);
  };
  try {
    return compiled(std::move(view));
  } catch (const emit::NoRoom& layers) {
    std::optional<scene::Scene> by_pattern = effects::by_screen_door(emit.scene);
    if (!by_pattern || see_through(emit, model.tree, camera) == nullptr) throw;
    emit.scene = std::move(*by_pattern);
    isa::Program program = compiled(view::make_view(model.scene, model.tree, camera, sampling_of(request, machine)));
    warn_of_pattern(layers, request, machine);
    return program;
  }
}

}  // namespace

view::View view_of(const CompiledModel& model, const ModelRequest& request, const machines::Machine& machine) {
  return view::make_view(model.scene, model.tree, model.camera, sampling_of(request, machine));
}

story::HalfspaceFinder halfspaces_of(const CompiledModel& model, const ModelRequest& request,
                                     const machines::Machine& machine) {
  return {model.tree, model.scene, view_of(model, request, machine)};
}

isa::Program compile_for_camera(const view::Camera& camera, const CompiledModel& model, const ModelRequest& request,
                                const machines::Machine& machine, csg::KeptResults* kept) {
  view::View view = view::make_view(model.scene, model.tree, camera, sampling_of(request, machine));
  warn_of_coarse_depth(view);
  std::size_t halfspaces = 0;
  for (const facet::Convex& solid : model.scene.solids) halfspaces += solid.halfspaces.size();
  return with_memory([&] { return short_of_memory(request.model, halfspaces); },
                     [&] { return compile_with_room(model, camera, std::move(view), request, machine, kept); });
}

CompiledModel facet_model(ModelFile file, const ModelRequest& request, const machines::Machine& machine) {
  return with_memory_for("the half-spaces of " + request.model,
                         [&] { return with_facets(std::move(file), request, machine); });
}

CompiledModel compile_model(ModelFile file, const ModelRequest& request, const machines::Machine& machine) {
  CompiledModel model = facet_model(std::move(file), request, machine);
  model.program = compile_for_camera(model.camera, model, request, machine);
  return model;
}

CompiledModel compile_model(const ModelRequest& request, const machines::Machine& machine) {
  return compile_model(read_model_file(request), request, machine);
}

}  // namespace csgsim::session
