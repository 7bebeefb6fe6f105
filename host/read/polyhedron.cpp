#include "host/read/polyhedron.h"

#include <algorithm>
#include <cmath>

#include "host/read/indices.h"
#include "host/read/mesh_pieces.h"
#include "host/solids/convex_faces.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

using Points = std::vector<glm::dvec3>;

Points read_points(const Arguments& arguments, ValueView list) {
  if (!list.is(ValueKind::vector)) arguments.fail(list, "points of polyhedron() must be a vector of [x, y, z]");
  Points points;
  list.for_each([&](ValueView value) {
    std::array<double, 3> point{};
    arguments.read_numbers(value, 3, point, "a point");
    points.emplace_back(point[0], point[1], point[2]);
  });
  return points;
}

struct Faces {
  std::vector<std::vector<std::uint32_t>> corners;
  std::vector<ValueView> places;
};

Faces read_faces(const Arguments& arguments, ValueView list, std::size_t points) {
  if (!list.is(ValueKind::vector)) arguments.fail(list, "faces of polyhedron() must be a vector of faces");
  Faces faces;
  list.for_each([&](ValueView value) {
    if (!value.is(ValueKind::vector)) arguments.fail(value, "a face must be a vector of indices of points");
    if (value.size() < 3) arguments.fail(value, "a face needs at least 3 corners; take it out or complete it");
    faces.corners.push_back(read_indices(arguments, value, points));
    faces.places.push_back(value);
  });
  return faces;
}

ValueView find_faces(const Arguments& arguments) {
  const std::optional<ValueView> triangles = arguments.find("triangles");
  if (!triangles) return arguments.required("faces", "faces = [[0, 1, 2], ...]");
  if (arguments.has("faces")) arguments.fail("faces and triangles are both given; take one out");
  return *triangles;
}

bool is_finite(const glm::dvec3& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

Made made_of(const Arguments& arguments) {
  // So OpenSCAD prints a polyhedron that was given none.
  if (arguments.is_undefined("points") || arguments.is_undefined("faces")) return {};
  const Points points = read_points(arguments, arguments.required("points", "points = [[x, y, z], ...]"));
  const Faces faces = read_faces(arguments, find_faces(arguments), points.size());
  if (!std::ranges::all_of(points, is_finite)) return {};
  const solids::Mesh mesh{points, faces.corners};
  if (auto solid = solids::as_convex_faces(solids::join_points(mesh).mesh)) return {{*std::move(solid)}, {}};
  MeshPieces found;
  try {
    found = pieces_of(mesh, solids::printed_tolerance);
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
  if (found.defect) arguments.fail(faces.places[found.defect->face], "{}", found.defect->what);
  return {std::move(found.pieces), {}};
}

}  // namespace

Maker read_polyhedron(const Arguments& arguments) {
  return [made = made_of(arguments)](const Operands& /*none*/) { return made; };
}

}  // namespace csgsim::read
