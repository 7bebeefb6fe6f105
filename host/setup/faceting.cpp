#include "host/setup/faceting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/emit/look.h"
#include "host/facet/curved.h"
#include "host/facet/geometry.h"
#include "host/setup/camera.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/prints.h"

namespace csgsim::setup {

namespace {

using emit::Curves;

/// A model, and the machine and camera for which it is faceted.
struct FacetingInput {
  const Choices& choices;
  const machines::Machine& machine;
  const model::Tree& tree;
  const view::Camera& camera;
};

bool is_tolerance_in_pixels(const FacetingChoice& choice) { return choice.tolerance && choice.tolerance->is_in_pixels; }

bool has_curves(const FacetingChoice& choice, const machines::Machine& machine) {
  if (choice.curves == Curves::automatic) return machine.evaluator_degree >= 2;
  return choice.curves != Curves::facets;
}

facet::Faceting planar(const FacetingChoice& choice) {
  return choice.tolerance ? facet::Faceting{.tolerance = choice.tolerance->value} : facet::Faceting{};
}

facet::Faceting planar(const FacetingInput& input) {
  if (!is_tolerance_in_pixels(input.choices.faceting)) return planar(input.choices.faceting);
  const facet::Geometry scene = facet::make_geometry(input.tree);
  const double nearest = view::make_view(scene, input.tree, input.camera, input.choices.sampling).depth.near;
  return {.tolerance = input.choices.faceting.tolerance->value *
                       view::pixel_size(input.camera, input.machine.picture.height, nearest)};
}

/// Marks the primitives whose quadrics, as seen by the camera, exceed the number range of the machine; empty if none
/// does.
std::vector<bool> unfit_primitives(const FacetingInput& input, const facet::Faceting& faceting) {
  const facet::Geometry scene = facet::make_geometry(input.tree, faceting);
  const view::View view = view::make_view(scene, input.tree, input.camera, input.choices.sampling);
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

/// The reason why a curved solid is not drawn as a fast sphere.
std::string why_faceted(const model::Primitive& primitive, bool is_perspective) {
  if (!std::holds_alternative<model::Sphere>(primitive.shape)) return "not a sphere";
  if (is_perspective) return "an ellipse in a perspective picture";
  if (!facet::keeps_balls(primitive.transform)) return "an ellipsoid";
  return "too large or too small for the machine's numbers";
}

/// Indices of curved solids that are drawn as facets.
std::vector<std::uint32_t> faceted_solids(const model::Tree& tree, const facet::Faceting& faceting) {
  facet::Faceting all_curved;
  all_curved.exact_curves = true;
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const model::Primitive& primitive = tree.primitives[i];
    const bool is_faceted = i < faceting.faceted.size() && faceting.faceted[i];
    const bool is_curved = facet::stays_curved(primitive, faceting) && !is_faceted;
    if (facet::stays_curved(primitive, all_curved) && !is_curved) left.push_back(i);
  }
  return left;
}

std::string others_text(std::size_t count) {
  if (count == 0) return "";
  return count == 1 ? ", as is 1 more curved solid" : fmt::format(", as are {} more curved solids", count);
}

void report_faceted(const std::vector<std::uint32_t>& left, const FacetingInput& input) {
  if (left.empty()) return;
  const std::string place = model::location_text(input.tree, left.front());
  const bool is_perspective = input.camera.projection == view::Projection::perspective;
  const std::string reason = why_faceted(input.tree.primitives[left.front()], is_perspective);
  report_line(
      fmt::format("{}: warning: --curves fast draws spheres in orthographic pictures; this solid is {} and is drawn as "
                  "facets{}",
                  place, reason, others_text(left.size() - 1)));
}

/// Those spheres that can be drawn as fast spheres, beside planar facets.
facet::Faceting with_fast_spheres(facet::Faceting faceting, const FacetingInput& input, const emit::Look& look) {
  if (const auto reason = emit::curves_unsupported_reason(input.machine, input.choices.options, look))
    throw InputError(*reason + ", or draw facets with --curves facets");
  if (input.camera.projection != view::Projection::perspective) {
    faceting.exact_curves = true;
    faceting.fast_spheres = true;
    faceting.faceted = unfit_primitives(input, faceting);
  }
  report_faceted(faceted_solids(input.tree, faceting), input);
  return faceting;
}

facet::Faceting with_quadrics(facet::Faceting faceting, const FacetingInput& input, const emit::Look& look) {
  const bool is_exact = input.choices.faceting.curves == Curves::exact;
  const std::optional<std::string> reason =
      emit::quadrics_unsupported_reason(input.machine, input.choices.options, look);
  if (reason && is_exact) throw InputError(*reason + ", or allow facets with --curves auto");
  if (reason) return faceting;
  faceting.exact_curves = true;
  if (!is_exact) faceting.faceted = unfit_primitives(input, faceting);
  return faceting;
}

facet::Faceting with_curves(facet::Faceting faceting, const FacetingInput& input) {
  const FacetingChoice& choice = input.choices.faceting;
  if (!has_curves(choice, input.machine)) return faceting;
  const emit::Look look =
      emit::make_look(input.choices.options.scene, input.tree, csg::make_positive_tree(input.tree), input.camera);
  return choice.curves == Curves::fast ? with_fast_spheres(std::move(faceting), input, look)
                                       : with_quadrics(std::move(faceting), input, look);
}

void print_tolerance(const Tolerance& asked, double tolerance) {
  print_text(fmt::format("{:<18}--tolerance {:.6g}: {:g} pixels at the nearest point of the model\n", "chosen",
                         tolerance, asked.value));
}

}  // namespace

facet::Faceting faceting_at(const view::Camera& camera, const Choices& choices, const machines::Machine& machine,
                            const model::Tree& tree) {
  const FacetingInput input{choices, machine, tree, camera};
  return with_curves(planar(input), input);
}

facet::Faceting faceting_for(const Choices& choices, const machines::Machine& machine, const model::Tree& tree) {
  const FacetingChoice& choice = choices.faceting;
  if (!is_tolerance_in_pixels(choice) && !has_curves(choice, machine)) return planar(choice);
  const view::Camera camera = camera_for(choices.camera, machine.picture, tree, facet::make_geometry(tree));
  const FacetingInput input{choices, machine, tree, camera};
  facet::Faceting faceting = planar(input);
  if (is_tolerance_in_pixels(choice)) print_tolerance(*choice.tolerance, *faceting.tolerance);
  return with_curves(std::move(faceting), input);
}

bool depends_on_camera(const FacetingChoice& choice, const machines::Machine& machine) {
  if (is_tolerance_in_pixels(choice)) return true;
  return choice.curves != Curves::facets && machine.evaluator_degree >= 2;
}

}  // namespace csgsim::setup
