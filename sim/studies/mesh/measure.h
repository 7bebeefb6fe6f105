// Points, rows and measurements of meshes.
// Used by csgsim mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/commands/read.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// A way to mesh a surface.
struct MeshPoint {
  std::string name;  ///< name of the sweep or patch in the file
  double tolerance = 0;
  std::string flatness;
  std::string repair;

  static void columns(auto& point, const auto& visit) {
    visit("name", point.name);
    visit("tolerance", point.tolerance);
    visit("flatness", point.flatness);
    visit("repair", point.repair);
  }
};

/// Results of a point.
struct MeshRow {
  static constexpr std::size_t point_columns = 4;

  MeshPoint point;
  Inputs inputs;
  std::uint64_t patches = 0;
  std::uint64_t elements = 0;
  std::uint64_t vertices = 0;
  std::uint64_t most_elements = 0;
  std::uint64_t most_vertices = 0;
  std::uint64_t most_edges = 0;
  std::uint64_t wire_vertices = 0;
  std::uint64_t tree_nodes = 0;
  std::uint64_t surface_points = 0;
  std::uint64_t flat_tests = 0;
  std::uint64_t halvings = 0;
  std::uint64_t sections = 0;
  std::uint64_t adds = 0;
  std::uint64_t products = 0;
  std::uint64_t quotients = 0;
  std::uint64_t roots = 0;
  std::uint64_t edge_visits = 0;
  std::uint64_t splits = 0;
  std::uint64_t merges = 0;
  std::uint64_t snaps = 0;
  std::string reason;

  [[nodiscard]] bool is_meshed() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    MeshPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("patches", row.patches);
    visit("elements", row.elements);
    visit("vertices", row.vertices);
    visit("most_elements", row.most_elements);
    visit("most_vertices", row.most_vertices);
    visit("most_edges", row.most_edges);
    visit("wire_vertices", row.wire_vertices);
    visit("tree_nodes", row.tree_nodes);
    visit("surface_points", row.surface_points);
    visit("flat_tests", row.flat_tests);
    visit("halvings", row.halvings);
    visit("sections", row.sections);
    visit("adds", row.adds);
    visit("products", row.products);
    visit("quotients", row.quotients);
    visit("roots", row.roots);
    visit("edge_visits", row.edge_visits);
    visit("splits", row.splits);
    visit("merges", row.merges);
    visit("snaps", row.snaps);
    visit("reason", row.reason);
  }
};

inline constexpr const char* repair_by_filter = "filter";
inline constexpr const char* repair_by_quadtree = "quadtree";
inline constexpr const char* flatness_of_plane = "plane";
inline constexpr const char* flatness_of_sides = "sides";

/// Meshes the surface and counts. If it cannot be meshed, the row holds the reason.
MeshRow measure(const MeshPoint& point, const Inputs& inputs, const commands::NamedSurface& surface);

/// The mesh of a point: `vertices` in model units, and `elements`, each a list of vertex numbers around the element,
/// starting at its south-west corner and including vertices on its sides. Throws InputError if the surface cannot be
/// meshed.
nlohmann::ordered_json mesh_json(const MeshPoint& point, const commands::NamedSurface& named);

}  // namespace csgsim::studies
