#include "sim/session/model/model_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "host/effects/rows.h"
#include "host/emit/curves.h"
#include "host/emit/effect.h"
#include "host/facet/geometry.h"
#include "host/lighting/colour_schemes.h"
#include "host/scene/read.h"
#include "host/setup/camera.h"
#include "host/setup/faceting.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
#include "sim/session/model/cameras.h"
#include "sim/session/model/parameter_sets.h"
#include "sim/session/model/prices.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/prunings.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

/// OpenSCAD's words for projections, and their first letters, which OpenSCAD also accepts.
const std::map<std::string, view::Projection> projections{{"ortho", view::Projection::orthographic},
                                                          {"o", view::Projection::orthographic},
                                                          {"perspective", view::Projection::perspective},
                                                          {"p", view::Projection::perspective}};

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const lighting::ColourScheme& scheme : lighting::colour_schemes()) names.emplace_back(scheme.name);
  return names;
}

void apply_scheme(const std::string& name, scene::Scene& scene) {
  for (const lighting::ColourScheme& scheme : lighting::colour_schemes())
    if (scheme.name == name) lighting::apply(scheme, scene);
}

/// Maps the name of each choice to the choice.
template <class Choices>
auto by_name(const Choices& choices) {
  std::map<std::string, typename Choices::value_type> named;
  for (const auto choice : choices) named.emplace(emit::name_of(choice), choice);
  return named;
}

/// Parses a number, or a number followed by px.
setup::Tolerance parse_tolerance(const std::string& text) {
  const bool is_in_pixels = text.ends_with("px");
  const std::string number = is_in_pixels ? text.substr(0, text.size() - 2) : text;
  const double value = numbers<double>(number, ',', 1, "--tolerance", is_in_pixels ? "0.5px" : "0.1, or 0.5px")[0];
  if (!(value > 0 && std::isfinite(value)))
    throw UsageError("--tolerance", fmt::format("'{}' is not a finite length above 0; write one such as 0.1", text));
  return {value, is_in_pixels};
}

constexpr InputKind scene_input{"a scene's .toml file", 1'000'000, "split the model's look into fewer materials"};

view::Projection projection_of(const ModelRequest& request) {
  if (!request.projection.empty()) return projections.at(request.projection);
  const bool is_perspective = request.scene().camera.is_perspective.value_or(false);
  return is_perspective ? view::Projection::perspective : view::Projection::orthographic;
}

/// What is wrong with a word of --define; empty if nothing.
std::string define_problem(const std::string& word) {
  const std::size_t end = word.find('=');
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '$'; };
  const bool is_named = end != word.npos && end > 0 &&
                        std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(end), is_letter);
  return is_named && end + 1 < word.size() ? "" : fmt::format("'{}' must be NAME=VALUE, as in width=20", word);
}

/// The camera of --camera; an empty text gives none.
std::optional<view::Camera> read_camera(const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return parse_camera(text);
  } catch (const CameraError& error) {
    throw UsageError("--camera", error.what());
  }
}

/// Distance of the near plane in the scene; an orthographic view has none.
std::optional<double> near_of(const ModelRequest& request) {
  return projection_of(request) == view::Projection::perspective ? request.scene().camera.near : std::nullopt;
}

/// Switches effects off, even if the scene or the model enables them.
void switch_off(const std::vector<std::string>& names, scene::Scene& scene) {
  for (const scene::Section& section : effects::sections()) {
    const auto is_named = [&](const std::string& name) { return section.name == "effects." + name; };
    if (std::none_of(names.begin(), names.end(), is_named)) continue;
    std::erase_if(scene.effects, [&](const scene::EffectRequest& one) { return one.name == section.name; });
    scene.effects.push_back({section.name, {}, false});
  }
}

}  // namespace

const ModelRequest::LoadedScene& ModelRequest::loaded_scene() const {
  if (scene_ != nullptr) return *scene_;
  LoadedScene loaded{scene_file.empty() ? "" : read_file(scene_file, scene_input), {}, {}};
  try {
    const std::vector<scene::Section> sections = effects::sections();
    loaded.scene =
        scene::read_scene(loaded.text, printable(scene_file), divide_settings(sets).scene, sections, &loaded.values);
  } catch (const scene::SetError& error) {
    throw UsageError(error.what());
  }
  switch_off(effects_off_, loaded.scene);
  apply_scheme(colour_scheme, loaded.scene);
  scene_ = std::make_shared<const LoadedScene>(std::move(loaded));
  return *scene_;
}

ModelRequest ModelRequest::without_effects(const std::vector<std::string>& names) const {
  ModelRequest fewer = *this;
  fewer.scene_ = nullptr;
  fewer.effects_off_ = names;
  return fewer;
}

ModelRequest parse_model_request(std::span<const std::string> words) {
  ModelRequest request;
  OptionList options("view");
  request.add_to(options);
  options.give_words(words);
  options.check_and_apply();
  return request;
}

ScadOptions ModelRequest::scad_options() const {
  if (parameters.empty() && !parameter_set.empty())
    throw UsageError("--parameter-set", "name the file that has the set, with -p FILE");
  if (!parameters.empty() && parameter_set.empty())
    throw UsageError("--parameters", "name one of the file's sets, with -P SET");
  if (!parameters.empty()) require_parameter_set(parameters, parameter_set);
  ScadOptions options{defines, parameters, parameter_set};
  if (openscad_seconds) options.time_limit = std::chrono::seconds(*openscad_seconds);
  return options;
}

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  names.reserve(std::size(emit::strategies));
  for (const auto strategy : emit::strategies) names.emplace_back(emit::name_of(strategy));
  return names;
}

void ModelRequest::add_to(OptionList& options, const std::string& what) {
  options.option("MODEL", model, what).required();
  options
      .option("--machine", machine,
              "A machine's name (see csgsim manual machines) or .toml file; NAME+KEY=VALUE changes a parameter")
      .check(check_by_parsing(check_machine));
  options.option("--memory-bits", memory_bits, "Memory bits per pixel; default: as in the machine's description")
      .between(1U, isa::max_memory_bits);
  add_view_to(options);
  options.option("--z-bits", z_bits, "Bits of depth").between(view::min_z_bits, view::max_z_bits);
  options
      .option("--strategy", strategy,
              "How pixels are classified; bits uses --stack-bits, auto chooses the fastest that fits the memory")
      .one_of(strategy_names());
  options
      .option(
          "--stack-bits", stack_bits,
          "Bits of --strategy bits, numbered as in the thesis: with 3, a primitive's depth is tested once per "
          "product; with 4, products are summed; each further bit stores the results of one more level of the tree; "
          "docs/accuracy.md#strategies explains them")
      .between(emit::min_stack_bits, max_stack_bits);
  options
      .option(
          "--colouring", colouring,
          "How pixels receive their colours: rebroadcast (facets again after the merge), field (a second colour field "
          "beside Z1), auto (the faster of these that fits the memory)")
      .one_of(by_name(emit::colourings));
  options
      .option("--pruning", pruning,
              "Prunings to apply: auto (all, where their tests take the host less time than they save), all, none, the "
              "named "
              "ones (space+hidden) or all but the named ones (no-space+no-hidden)")
      .words(pruning_words(), check_by_parsing(parse_pruning));
}

void ModelRequest::add_view_to(OptionList& options) {
  options.option("--size,--imgsize", size,
                 "Picture and array size in pixels, WxH; default: as in the machine's description");
  options.read_option(
      "--camera", [this](const std::string& text) { camera = read_camera(text); },
      "As in OpenSCAD: eye and centre, ex,ey,ez,cx,cy,cz; or centre, rotations and distance, x,y,z,rx,ry,rz,d");
  options
      .option("--projection", projection, "ortho (o) or perspective (p); default: that of the scene, otherwise ortho")
      .one_of(projections);
  options.option("--scene", scene_file, "Lights, materials, background, camera and effects: a .toml file");
  options
      .option("--colour-scheme,--colorscheme", colour_scheme,
              "Background and default face colours of the OpenSCAD colour scheme of that name")
      .one_of(scheme_names());
  options.option("--set", sets,
                 "A parameter of the machine, as in alu.bits=4, or a key of the scene, as in "
                 "lights.0.direction=0,0,-1; repeat for "
                 "several");
  options.option("--imports-from", imports_from,
                 "Folder to search, with its subfolders, for the model's imports, in addition to the model's own "
                 "folder");
  options.option("--openscad-time", openscad_seconds,
                 "Time limit in seconds for OpenSCAD to evaluate a model's source; default: 1800");
  options
      .option("-D,--define", defines,
              "A variable of a model's source and its value, NAME=VALUE, as in OpenSCAD; quote texts: -D 'name=\"A\"'; "
              "repeat for several")
      .check(define_problem);
  options.option("-p,--parameters", parameters, "OpenSCAD's parameter sets for a model's source: a .json file")
      .check(not_empty);
  options.option("-P,--parameter-set", parameter_set, "The set of --parameters to use").check(not_empty);
  options.flag("--snap", snap,
               "Restore rotations by hundredths of a degree from OpenSCAD's six-digit output, so that planes that "
               "should coincide do");
  options
      .option("--limit", limit,
              "Stop with an error when reading or compiling the model needs more than this number of million steps")
      .between(1U, max_work_limit);
  options.flag("--view-all,--viewall", view_all, "Move the camera so that the whole model just fits the picture");
  options.option("--near", near,
                 "Distance of the near plane of a perspective view, in model units; solids are capped there");
  options.option("--fraction-bits", fraction_bits, "Fraction bits of the planes' coefficients")
      .between(0U, view::max_fraction_bits);
  options.option("--edge-on", edge_on,
                 "Fraction of a pixel within which a plane that crosses the whole depth range becomes an edge test");
  options.read_option(
      "--tolerance", [this](const std::string& text) { tolerance = parse_tolerance(text); },
      "Maximum distance of facets from a curved solid's surface, in model units (0.1) or in pixels (0.5px), instead "
      "of OpenSCAD's number of facets");
  options
      .option("--curves", curves,
              "How spheres, cylinders and cones are drawn: facets; fast (spheres as circles and paraboloids, on any "
              "machine); exact (without facets, on a machine whose evaluator.degree is 2); auto (exact where the "
              "machine and the scene's effects allow it)")
      .one_of(by_name(emit::curve_choices), "curve drawing");
  options.option("--colour-bits", colour_bits, "Colour bits per pixel, over all three channels")
      .between(isa::minimum_colour_bits, isa::max_colour_bits);
}

machines::Machine machine_of(const ModelRequest& request) {
  machines::Machine machine = load_machine(request.machine, request.sets);
  if (!request.size.empty()) {
    const char between = request.size.find(',') == std::string::npos ? 'x' : ',';
    const auto size = numbers<std::uint32_t>(request.size, between, 2, "--size", "WxH, as in 640x480");
    if (std::ranges::any_of(size, [](std::uint32_t side) { return side < 1 || side > isa::max_array_side; })) {
      throw UsageError("--size",
                       fmt::format("'{}': width and height must be 1 to {} pixels", request.size, isa::max_array_side));
    }
    machines::set_picture_size(machine, {size[0], size[1]});
  }
  if (request.memory_bits) machine.array.memory_bits = *request.memory_bits;
  return machine;
}

Work work_of(const ModelRequest& request) { return Work(request.limit * std::uint64_t{1'000'000}); }

emit::Options emit_options_of(const ModelRequest& request) {
  emit::Options emit;
  emit.strategy = by_name(emit::strategies).at(request.strategy);
  emit.stack_bits = request.stack_bits;
  emit.colouring = by_name(emit::colourings).at(request.colouring);
  emit.colour_bits = request.colour_bits;
  emit.scene = request.scene();
  emit.effects = effects::all();
  emit.pruning = parse_pruning(request.pruning);
  emit.prices_on = request.pruning == automatic_pruning ? weighed_prices_on : prices_on;
  emit.work = work_of(request);
  return emit;
}

view::Sampling sampling_of(const ModelRequest& request, const machines::Machine& machine) {
  if (request.near && projection_of(request) != view::Projection::perspective) {
    throw UsageError("--near", "an orthographic view has no near plane; leave it out");
  }
  if (request.near && !(*request.near > 0 && std::isfinite(*request.near)))
    throw UsageError("--near",
                     fmt::format("{:g} is not a finite distance above 0; give one such as 0.1", *request.near));
  if (!(request.edge_on > 0 && request.edge_on <= 1))
    throw UsageError("--edge-on",
                     fmt::format("{:g} is not a fraction of a pixel; give one above 0, at most 1", request.edge_on));
  const machines::Size picture = machine.picture;
  const std::optional<double> near = request.near ? request.near : near_of(request);
  return {picture.width, picture.height, request.z_bits, request.fraction_bits, request.edge_on, near};
}

namespace {

setup::CameraChoice camera_choice_of(const ModelRequest& request) {
  const scene::Camera& seen_by = request.scene().camera;
  return {.given = request.camera,
          .eye = seen_by.eye,
          .centre = seen_by.centre,
          .projection = projection_of(request),
          .shows_all = request.view_all || seen_by.view_all.value_or(false)};
}

emit::Curves curves_of(const ModelRequest& request) { return by_name(emit::curve_choices).at(request.curves); }

}  // namespace

setup::Choices choices_of(const ModelRequest& request, const machines::Machine& machine) {
  return {.sampling = sampling_of(request, machine),
          .camera = camera_choice_of(request),
          .faceting = {request.tolerance, curves_of(request)},
          .options = emit_options_of(request)};
}

facet::Faceting faceting_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree) {
  return setup::faceting_for(choices_of(request, machine), machine, tree);
}

facet::Faceting flat_faceting_of(const ModelRequest& request, const machines::Machine& machine,
                                 const model::Tree& tree) {
  setup::Choices choices = choices_of(request, machine);
  emit::Curves& curves = choices.faceting.curves;
  if (curves == emit::Curves::exact || curves == emit::Curves::fast)
    throw UsageError("--curves", "this command supports facets only; leave it out");
  curves = emit::Curves::facets;
  return setup::faceting_for(choices, machine, tree);
}

view::Camera camera_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree,
                       const facet::Geometry& scene) {
  return setup::camera_for(camera_choice_of(request), machine.picture, tree, scene);
}

std::vector<std::filesystem::path> ModelRequest::inputs() const {
  std::vector<std::string> files{model};
  for (const std::string& file : {scene_file, parameters})
    if (!file.empty()) files.push_back(file);
  return input_files(files, {machine});
}

}  // namespace csgsim::session
