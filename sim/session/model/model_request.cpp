#include "sim/session/model/model_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "host/convex/extent.h"
#include "host/csg/positive_tree.h"
#include "host/effects/rows.h"
#include "host/emit/curves.h"
#include "host/emit/effect.h"
#include "host/facet/geometry.h"
#include "host/lighting/colour_schemes.h"
#include "host/scene/read.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/prints.h"
#include "hw/base/text.h"
#include "sim/session/model/cameras.h"
#include "sim/session/model/fast_curves.h"
#include "sim/session/model/prices.h"
#include "sim/session/model/scad.h"
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
Tolerance parse_tolerance(const std::string& text) {
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

/// The camera of --camera, if it is given.
std::optional<view::Camera> given_camera(const ModelRequest& request) {
  if (request.camera.empty()) return std::nullopt;
  try {
    return parse_camera(request.camera);
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
    loaded.scene = scene::read_scene(loaded.text, printable(scene_file), sorted(sets).scene, sections, &loaded.values);
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

ModelRequest model_request_in(std::span<const std::string> words) {
  ModelRequest request;
  OptionList options("view");
  request.add_to(options);
  options.give_words(words);
  options.take();
  return request;
}

std::chrono::seconds ModelRequest::openscad_time() const {
  return openscad_seconds ? std::chrono::seconds(*openscad_seconds) : default_openscad_time;
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
      .check(is_read_by(check_machine));
  options.option("--memory-bits", memory_bits, "Memory bits per pixel; default: as in the machine's description")
      .between(1U, isa::max_memory_bits);
  add_view_to(options);
  options.option("--z-bits", z_bits, "Bits of depth").between(view::min_z_bits, view::max_z_bits);
  options
      .option("--strategy", strategy,
              "How pixels are classified; bits uses --stack-bits, auto chooses the fastest that fits the memory")
      .one_of(strategy_names());
  options
      .option("--stack-bits", stack_bits,
              "Bits of --strategy bits, numbered as in the thesis: with 3, a primitive's depth is tested once per "
              "product; with 4, products are summed; each further bit stores the results of one more level of the tree")
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
      .words(pruning_words(), is_read_by(pruning_of));
}

void ModelRequest::add_view_to(OptionList& options) {
  options.option("--size,--imgsize", size,
                 "Picture and array size in pixels, WxH; default: as in the machine's description");
  options.option(
      "--camera", camera,
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
  emit.pruning = pruning_of(request.pruning);
  emit.prices_on = request.pruning == all_that_pay ? weighed_prices_on : prices_on;
  emit.work = work_of(request);
  return emit;
}

namespace {

/// The faceting of the request without curved surfaces.
facet::Faceting planar_faceting_of(const ModelRequest& request, const machines::Machine& machine,
                                   const model::Tree& tree) {
  if (!request.tolerance) return {};
  if (!request.tolerance->is_in_pixels) return {.tolerance = request.tolerance->value};
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::Camera camera = camera_of(request, machine, tree, scene);
  const double nearest = view::make_view(scene, tree, camera, sampling_of(request, machine)).depth.near;
  const double tolerance = request.tolerance->value * view::pixel_size(camera, machine.picture.height, nearest);
  if (!request.frame_camera) {
    print_text(fmt::format("{:<18}--tolerance {:.6g}: {:g} pixels at the nearest point of the model\n", "chosen",
                           tolerance, request.tolerance->value));
  }
  return {.tolerance = tolerance};
}

}  // namespace

std::vector<bool> unfit_primitives(const facet::Geometry& scene, const view::View& view) {
  std::vector<bool> unfit(scene.solids.size());
  bool any = false;
  for (std::size_t i = 0; i < unfit.size(); ++i) {
    const std::vector<facet::QuadricSide>& quadrics = scene.solids[i].quadrics;
    unfit[i] = std::ranges::any_of(quadrics, [&](const facet::QuadricSide& side) {
      return view.quadrics[side.quadric].kind == view::ScreenQuadricKind::unfit;
    });
    any = any || unfit[i];
  }
  return any ? unfit : std::vector<bool>{};
}

facet::Faceting faceting_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree) {
  facet::Faceting faceting = planar_faceting_of(request, machine, tree);
  const emit::Curves curves = by_name(emit::curve_choices).at(request.curves);
  if (curves == emit::Curves::facets) return faceting;
  if (curves == emit::Curves::automatic && machine.evaluator_degree < 2) return faceting;
  const emit::Options emit = emit_options_of(request);
  const view::Camera camera = camera_of(request, machine, tree, facet::make_geometry(tree));
  const emit::Look look = emit::make_look(emit.scene, tree, csg::make_positive(tree), camera);
  if (curves == emit::Curves::fast)
    return with_fast_spheres(std::move(faceting), tree, camera, sampling_of(request, machine), machine, emit, look);
  const std::optional<std::string> reason = emit::why_no_quadrics(machine, emit, look);
  if (reason && curves == emit::Curves::exact) throw InputError(*reason + ", or allow facets with --curves auto");
  if (reason) return faceting;
  faceting.exact_curves = true;
  if (curves == emit::Curves::exact) return faceting;
  const facet::Geometry scene = facet::make_geometry(tree, faceting);
  faceting.faceted = unfit_primitives(scene, view::make_view(scene, tree, camera, sampling_of(request, machine)));
  return faceting;
}

facet::Faceting flat_faceting_of(const ModelRequest& request, const machines::Machine& machine,
                                 const model::Tree& tree) {
  const emit::Curves curves = by_name(emit::curve_choices).at(request.curves);
  if (curves == emit::Curves::exact || curves == emit::Curves::fast)
    throw UsageError("--curves", "this command supports facets only; leave it out");
  return planar_faceting_of(request, machine, tree);
}

view::Sampling sampling_of(const ModelRequest& request, const machines::Machine& machine) {
  if (request.near && projection_of(request) != view::Projection::perspective) {
    throw UsageError("--near", "an orthographic view has no near plane; leave it out");
  }
  if (request.near && !(*request.near > 0 && std::isfinite(*request.near)))
    throw UsageError("--near", fmt::format("{:g} is not a finite distance above 0", *request.near));
  if (!(request.edge_on > 0 && request.edge_on <= 1))
    throw UsageError("--edge-on", fmt::format("{:g} is not a fraction of a pixel above 0, at most 1", request.edge_on));
  const machines::Size picture = machine.picture;
  const std::optional<double> near = request.near ? request.near : near_of(request);
  return {picture.width, picture.height, request.z_bits, request.fraction_bits, request.edge_on, near};
}

view::Camera camera_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree,
                       const facet::Geometry& scene) {
  return request.frame_camera ? *request.frame_camera : camera_of(request, machine, tree, scene, given_camera(request));
}

view::Camera camera_of(const ModelRequest& request, const machines::Machine& machine, const model::Tree& tree,
                       const facet::Geometry& scene, const std::optional<view::Camera>& given) {
  const machines::Size picture = machine.picture;
  const scene::Camera& seen_by = request.scene().camera;
  const bool is_given = given || (seen_by.eye && seen_by.centre);
  const bool sees_all = request.view_all || seen_by.view_all.value_or(false);
  // The view must not depend on how curved surfaces are drawn.
  const bool has_quadrics = !scene.quadrics.quadrics().empty();
  const facet::Box box = is_given && !sees_all ? scene.box
                         : has_quadrics        ? convex::extent(facet::make_geometry(tree), csg::make_positive(tree))
                                               : convex::extent(scene, csg::make_positive(tree));
  view::Camera camera = view::default_camera(box, picture.width, picture.height);
  camera.eye = seen_by.eye.value_or(camera.eye);
  camera.centre = seen_by.centre.value_or(camera.centre);
  if (given) camera = *given;
  camera.projection = projection_of(request);
  return sees_all ? view::view_all(camera, box, picture.width, picture.height) : camera;
}

bool is_faceted_for_camera(const ModelRequest& request, const machines::Machine& machine) {
  if (request.tolerance && request.tolerance->is_in_pixels) return true;
  return by_name(emit::curve_choices).at(request.curves) != emit::Curves::facets && machine.evaluator_degree >= 2;
}

std::vector<std::filesystem::path> ModelRequest::inputs() const {
  return input_files(scene_file.empty() ? std::vector{model} : std::vector{model, scene_file}, {machine});
}

}  // namespace csgsim::session
