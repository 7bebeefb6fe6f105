#include "sim/studies/mesh/measure.h"

#include <memory>

#include "host/swept/mesh.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

void tell(const swept::SubdivisionCounts& counts, MeshRow& row) {
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

void tell(const swept::RepairCounts& counts, MeshRow& row) {
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

void mesh(const commands::NamedSurface& named, MeshRow& row) {
  const std::unique_ptr<swept::Surface> surface =
      named.is_sweep ? swept::surface_of(named.sweep) : swept::surface_of(named.net);
  swept::Accuracy accuracy;
  accuracy.tolerance = row.point.tolerance;
  accuracy.flatness = row.point.flatness == of_plane ? swept::Flatness::plane : swept::Flatness::sides;
  const swept::Patchwork made = swept::patchwork_of(
      *surface, accuracy, row.point.repair == by_filter ? swept::Repair::filter : swept::Repair::quadtree);
  row.patches = surface->columns() * surface->rows();
  row.wire_vertices = made.wire_vertices;
  tell(made.wiring, row);
  tell(made.subdivision, row);
  tell(made.repair, row);
}

}  // namespace

MeshRow measure(const MeshPoint& point, const Inputs& inputs, const commands::NamedSurface& surface) {
  return measured_row<MeshRow>(point, inputs, [&](MeshRow& row) { mesh(surface, row); });
}

}  // namespace csgsim::studies
