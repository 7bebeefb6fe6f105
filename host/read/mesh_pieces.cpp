#include "host/read/mesh_pieces.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

#include "host/solids/convex_faces.h"
#include "host/solids/hull.h"

namespace csgsim::read {

namespace {

/// Cost per face, in steps of work: edges are sorted and joined, and crossing faces are searched.
constexpr std::uint64_t check_steps = 3'000;

Remark bent_faces(const solids::BentFaces& bent, bool is_hull) {
  std::string what =
      bent.count == 1 ? fmt::format("faces[{}] is not flat: a corner is {:.3g} model units off the plane of the face",
                                    bent.first, bent.max_deviation)
                      : fmt::format(
                            "faces[{}] and {} more are not flat: corners are up to {:.3g} model units "
                            "off the planes of their faces",
                            bent.first, bent.count - 1, bent.max_deviation);
  what += is_hull
              ? "; the solid is nearly convex and combined with others, so its convex hull replaces it, as in OpenSCAD"
              : "; csgsim cuts such faces into triangles, as OpenSCAD does";
  if (bent.first_different && !is_hull)
    what += fmt::format(", except faces[{}], which crosses itself in OpenSCAD's projection", *bent.first_different);
  return {bent.first, std::move(what)};
}

constexpr std::string_view enclosed_space_is_drawn =
    "csgsim draws the enclosed space, as OpenSCAD shows the mesh alone; OpenSCAD's Booleans reject the mesh";

Remark crossing_faces(const solids::Crossing& crossing) {
  const std::string more = crossing.count > 1 ? fmt::format(", and so do {} more pairs", crossing.count - 1) : "";
  return {crossing.other, fmt::format("faces[{}] and faces[{}] cross by {:.3g} model units{}: {}", crossing.one,
                                      crossing.other, crossing.depth, more, enclosed_space_is_drawn)};
}

Remark crossing_edges() { return {0, fmt::format("the faces cross along their edges: {}", enclosed_space_is_drawn)}; }

Remark turned_faces(const solids::TurnedFaces& turned) {
  const std::string which = turned.count == 1
                                ? fmt::format("faces[{}] is oriented opposite to its neighbours", turned.first)
                                : fmt::format("faces[{}] and {} more are oriented opposite to their neighbours",
                                              turned.first, turned.count - 1);
  return {turned.first, fmt::format("{}; csgsim turns {}, so that the solid looks as OpenSCAD shows it alone; "
                                    "OpenSCAD's Booleans reject the solid",
                                    which, turned.count == 1 ? "it" : "them")};
}

struct Divided {
  std::vector<model::Polyhedron> pieces;
  std::optional<Remark> crossing{};  ///< set for a mesh that crosses itself
};

Divided divide(const solids::CheckedMesh& checked, const solids::Limits& limits) {
  if (checked.crossing) return {solids::enclosed_pieces(checked.mesh, limits), crossing_faces(*checked.crossing)};
  try {
    return {solids::convex_pieces(checked.mesh, limits)};
  } catch (const solids::WindingError&) {
    return {solids::enclosed_pieces(checked.mesh, limits), crossing_edges()};
  }
}

/// The hull of a mesh with several pieces, if OpenSCAD replaces the mesh by its hull.
std::optional<model::Polyhedron> replacement_hull(const solids::Mesh& mesh, std::size_t pieces,
                                                  const solids::MeshPlacement& mesh_placement, const Work& work) {
  if (pieces < 2 || !mesh_placement.meets_others || !solids::is_nearly_convex(mesh)) return std::nullopt;
  return solids::hull_piece(mesh.points, work);
}

}  // namespace

MeshPieces pieces_of(const solids::Mesh& mesh, double tolerance, const solids::MeshPlacement& mesh_placement,
                     const Work& work) {
  work.charge(check_steps * mesh.faces.size(), "checking a mesh of " + std::to_string(mesh.faces.size()) + " faces");
  solids::CheckedMesh checked = solids::check(mesh, tolerance, mesh_placement);
  if (checked.defect) return {{}, std::move(checked.defect)};
  solids::Limits limits;
  limits.tolerance = tolerance;
  limits.work = work;
  Divided divided = divide(checked, limits);
  MeshPieces made{std::move(divided.pieces)};
  bool is_hull = false;
  if (divided.crossing) {
    made.remarks.push_back(*std::move(divided.crossing));
  } else if (auto hull = replacement_hull(checked.mesh, made.pieces.size(), mesh_placement, work)) {
    made.pieces = {*std::move(hull)};
    is_hull = true;
  }
  if (checked.turned.count > 0) made.remarks.push_back(turned_faces(checked.turned));
  if (checked.bent.count > 0) made.remarks.push_back(bent_faces(checked.bent, is_hull));
  return made;
}

}  // namespace csgsim::read
