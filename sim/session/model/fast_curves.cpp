#include "sim/session/model/fast_curves.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <variant>

#include "host/emit/curves.h"
#include "host/facet/curved.h"
#include "host/facet/geometry.h"
#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

namespace {

/// The reason why a curved solid is not drawn as a fast sphere.
std::string why_not(const model::Primitive& primitive, bool is_perspective) {
  if (!std::holds_alternative<model::Sphere>(primitive.shape)) return "not a sphere";
  if (is_perspective) return "an ellipse in a perspective picture";
  if (!facet::keeps_balls(primitive.transform)) return "an ellipsoid";
  return "too large or too small for the machine's numbers";
}

/// Curved solids that are drawn as facets.
struct LeftFaceted {
  std::uint64_t count = 0;
  std::uint32_t first = model::no_index;
};

LeftFaceted left_faceted(const model::Tree& tree, const facet::Faceting& faceting) {
  facet::Faceting all_curved;
  all_curved.exact_curves = true;
  LeftFaceted left;
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const model::Primitive& primitive = tree.primitives[i];
    const bool is_faceted = i < faceting.faceted.size() && faceting.faceted[i];
    if (!facet::stays_curved(primitive, all_curved) || (facet::stays_curved(primitive, faceting) && !is_faceted))
      continue;
    if (left.count++ == 0) left.first = i;
  }
  return left;
}

std::string others(std::uint64_t count) {
  if (count == 0) return "";
  return count == 1 ? ", as is 1 more curved solid" : fmt::format(", as are {} more curved solids", count);
}

void report_faceted(const LeftFaceted& left, const model::Tree& tree, bool is_perspective) {
  if (left.count == 0) return;
  const model::Primitive& first = tree.primitives[left.first];
  report_line(
      fmt::format("{}: warning: --curves fast draws spheres in orthographic pictures; this solid is {} and is drawn as "
                  "facets{}",
                  model::place_of(tree, left.first), why_not(first, is_perspective), others(left.count - 1)));
}

}  // namespace

facet::Faceting with_fast_spheres(facet::Faceting planar, const model::Tree& tree, const view::Camera& camera,
                                  const view::Sampling& sampling, const machines::Machine& machine,
                                  const emit::Options& options, const emit::Look& look) {
  if (const auto reason = emit::why_no_curves(machine, options, look))
    throw InputError(*reason + ", or draw facets with --curves facets");
  const bool is_perspective = camera.projection == view::Projection::perspective;
  facet::Faceting faceting = std::move(planar);
  if (!is_perspective) {
    faceting.exact_curves = true;
    faceting.fast_spheres = true;
    const facet::Geometry scene = facet::make_geometry(tree, faceting);
    faceting.faceted = unfit_primitives(scene, view::make_view(scene, tree, camera, sampling));
  }
  report_faceted(left_faceted(tree, faceting), tree, is_perspective);
  return faceting;
}

}  // namespace csgsim::session
