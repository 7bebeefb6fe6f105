#include "host/read/polyhedron.h"

#include <algorithm>
#include <cmath>

#include "host/read/convexity.h"
#include "host/read/limits.h"
#include "host/read/mesh.h"

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

std::uint32_t read_corner(const Arguments& arguments, ValueView value, std::size_t points) {
  const double number = arguments.read_number(value, "a corner of a face");
  if (!(number >= 0 && number < static_cast<double>(points))) {
    arguments.fail(value, "there is no points[{}]; {}", number,
                   points == 0 ? "there are none" : fmt::format("a face names points[0] to points[{}]", points - 1));
  }
  if (number != std::floor(number)) arguments.fail(value, "a corner of a face must be a whole number");
  return static_cast<std::uint32_t>(number);
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
    std::vector<std::uint32_t>& face = faces.corners.emplace_back();
    value.for_each([&](ValueView corner) { face.push_back(read_corner(arguments, corner, points)); });
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

}  // namespace

std::optional<model::Polyhedron> read_polyhedron(const Arguments& arguments) {
  // So OpenSCAD prints a polyhedron that was given none.
  if (arguments.is_undefined("points") || arguments.is_undefined("faces")) return std::nullopt;
  const Points points = read_points(arguments, arguments.required("points", "points = [[x, y, z], ...]"));
  const Faces faces = read_faces(arguments, find_faces(arguments), points.size());
  if (!std::ranges::all_of(points, is_finite)) return std::nullopt;

  Mesh mesh = make_mesh(points, faces.corners);
  if (mesh.points.size() * mesh.faces.size() > max_points_times_faces) {
    arguments.fail("a polyhedron of {} points and {} faces is too large; make it coarser", mesh.points.size(),
                   mesh.faces.size());
  }
  const auto report = [&](const std::optional<Defect>& defect) {
    if (defect) arguments.fail(faces.places[defect->face], "{}", defect->what);
  };
  Planes planes = fit_planes(mesh);
  if (is_flat(mesh, planes)) return std::nullopt;
  report(find_open_edge(mesh));
  report(find_face_without_area(mesh, planes));
  turn_outwards(mesh, planes);
  report(find_bent_face(mesh, planes));
  report(find_dent(mesh, planes));
  return model::Polyhedron{std::move(mesh.points), std::move(mesh.faces)};
}

}  // namespace csgsim::read
