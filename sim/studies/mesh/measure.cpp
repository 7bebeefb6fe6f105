#include "sim/studies/mesh/measure.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "host/swept/mesh.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

void copy_counts(const swept::SubdivisionCounts& counts, MeshRow& row) {
  row.tree_nodes += counts.nodes;
  row.surface_points += counts.points;
  row.flat_tests += counts.tests;
  row.halvings += counts.halvings;
  row.sections += counts.sections;
  row.adds += counts.arithmetic.adds;
  row.products += counts.arithmetic.products;
  row.quotients += counts.arithmetic.quotients;
  row.roots += counts.arithmetic.roots;
}

void copy_counts(const swept::RepairCounts& counts, MeshRow& row) {
  row.elements = counts.elements;
  row.vertices = counts.vertices;
  row.most_elements = counts.most_elements;
  row.most_vertices = counts.most_vertices;
  row.most_edges = counts.most_edges;
  row.edge_visits = counts.edges_visited;
  row.splits = counts.splits;
  row.merges = counts.merges;
  row.snaps = counts.snaps;
}

std::unique_ptr<swept::Surface> make_surface(const commands::NamedSurface& named) {
  return named.is_sweep ? swept::make_surface(named.sweep) : swept::make_surface(named.net);
}

swept::Patchwork create_patchwork(swept::Surface& surface, const MeshPoint& point) {
  swept::Accuracy accuracy;
  accuracy.tolerance = point.tolerance;
  accuracy.flatness = point.flatness == flatness_of_plane ? swept::Flatness::plane : swept::Flatness::sides;
  return swept::make_patchwork(surface, accuracy,
                               point.repair == repair_by_filter ? swept::Repair::filter : swept::Repair::quadtree);
}

void mesh(const commands::NamedSurface& named, MeshRow& row) {
  const std::unique_ptr<swept::Surface> surface = make_surface(named);
  const swept::Patchwork made = create_patchwork(*surface, row.point);
  row.patches = surface->columns() * surface->rows();
  row.wire_vertices = made.wire_vertices;
  copy_counts(made.wiring, row);
  copy_counts(made.subdivision, row);
  copy_counts(made.repair, row);
}

}  // namespace

nlohmann::ordered_json mesh_json(const MeshPoint& point, const commands::NamedSurface& named) {
  using Json = nlohmann::ordered_json;
  const std::unique_ptr<swept::Surface> surface = make_surface(named);
  const swept::Patchwork made = create_patchwork(*surface, point);
  Json vertices = Json::array();
  for (const glm::dvec3& place : made.points) vertices.push_back(Json::array({place.x, place.y, place.z}));
  return {{"name", point.name},     {"tolerance", point.tolerance},    {"flatness", point.flatness},
          {"repair", point.repair}, {"vertices", std::move(vertices)}, {"elements", made.elements}};
}

MeshRow measure(const MeshPoint& point, const Inputs& inputs, const commands::NamedSurface& surface) {
  return measured_row<MeshRow>(point, inputs, [&](MeshRow& row) { mesh(surface, row); });
}

}  // namespace csgsim::studies
