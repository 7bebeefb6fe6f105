#include <optional>
#include <utility>

#include "host/read/mesh_pieces.h"
#include "host/read/node_readers.h"
#include "host/read/shared_arguments.h"
#include "host/solids/convex_faces.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

/// Faces with fewer than 3 corners are kept, so that indices match the file; the mesh drops them later.
struct Faces {
  std::vector<std::vector<std::uint32_t>> corners;
  std::vector<ValueView> places;
};

Faces read_faces(const Arguments& arguments, ValueView list, std::size_t points) {
  if (!list.is(ValueKind::vector)) arguments.fail(list, "faces of polyhedron() must be a vector of faces");
  Faces faces;
  IndexReader reader(arguments, points);
  list.for_each([&](ValueView value) {
    std::vector<std::uint32_t> corners = reader.read(value);
    if (corners.size() < 3) reader.warn(value, "a face has fewer than 3 corners; it is dropped");
    faces.corners.push_back(std::move(corners));
    faces.places.push_back(value);
  });
  return faces;
}

ValueView find_faces(const Arguments& arguments) {
  const std::optional<ValueView> triangles = arguments.find("triangles");
  if (!triangles) return arguments.required("faces", "faces = [[0, 1, 2], ...]");
  if (arguments.has("faces")) arguments.fail("faces and triangles are both given; remove one");
  return *triangles;
}

NodeResult make_polyhedron(const Arguments& arguments) {
  // OpenSCAD writes a polyhedron without points or faces this way.
  if (arguments.is_undefined("points") || arguments.is_undefined("faces")) return {};
  const std::optional<std::vector<glm::dvec3>> points = read_points<3>(arguments, "polyhedron", "it is dropped");
  if (!points) return {};
  const Faces faces = read_faces(arguments, find_faces(arguments), points->size());
  const solids::Mesh mesh{*points, faces.corners};
  if (auto solid = solids::as_convex_faces(solids::join_points(mesh).mesh)) return {{*std::move(solid)}, {}};
  MeshPieces found;
  try {
    solids::MeshPlacement mesh_placement = arguments.mesh_placement();
    mesh_placement.is_reversed = true;
    found = pieces_of(mesh, solids::printed_tolerance, mesh_placement, arguments.work());
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
  if (found.defect) arguments.fail(faces.places[found.defect->face], "{}", found.defect->what);
  for (const Remark& remark : found.remarks) arguments.report(faces.places[remark.face], remark.what);
  return {std::move(found.pieces), {}};
}

}  // namespace

Maker read_polyhedron(const Arguments& arguments) {
  NodeResult made = make_polyhedron(arguments);
  made.dimensions = 3;
  return [made = std::move(made)](const Operands& /*none*/) { return made; };
}

}  // namespace csgsim::read
