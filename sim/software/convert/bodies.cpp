#include "sim/software/convert/bodies.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "host/convex/clip.h"
#include "host/facet/geometry.h"
#include "host/facet/solid.h"
#include "host/facet/solid_at.h"
#include "sim/software/convert/exact_faces.h"
#include "sim/software/convert/face_planes.h"

namespace csgsim::software::convert {

namespace {

/// Converts to single precision, rounding outwards.
csg::BoxIndex::Box index_box(const UnitBox& box) {
  csg::BoxIndex::Box result;
  constexpr float far = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    result.low[i] = std::nextafter(static_cast<float>(box.low[axis]), -far);
    result.high[i] = std::nextafter(static_cast<float>(box.high[axis]), far);
  }
  return result;
}

/// Maximum distance of merged points, relative to the model's diagonal.
constexpr double coarsest = convex::relative_tolerance;
/// Maximum distance of merged points, relative to the minimum width of a node of the file.
constexpr double part_of_width = 1e-5;
/// Maximum displacement of a face to share a plane, relative to the tolerance.
constexpr double part_of_tolerance = 0.3;
/// Maximum displacement of a face to share a plane, relative to the solid's thickness.
constexpr double part_of_thickness = 1e-3;
/// Minimum tolerance, relative to the diagonal; keeps quotients finite.
constexpr double finest = 1e-24;
/// Error of a chain of transforms in doubles, relative to the coordinates.
constexpr double rounding = 0x1p-50;

glm::dvec3 middle_of(const facet::Solid& solid) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& vertex : solid.vertices) sum += vertex;
  return sum / static_cast<double>(solid.vertices.size());
}

/// Lower bound of half a solid's thickness: the distance from the mean of its vertices to the nearest face.
double inner_radius(const facet::Solid& solid, const glm::dvec3& middle) {
  double inner = std::numeric_limits<double>::infinity();
  for (const facet::Face& face : solid.faces) inner = std::min(inner, -face.plane.height(middle));
  return std::max(0.0, inner);
}

/// The size of a model, which its planes depend on.
struct Size {
  facet::Box box;
  double min_body_width = std::numeric_limits<double>::infinity();  ///< minimum over nodes of the file
};

/// Size of a node of the file: its pieces form one solid, and some of them may be slivers.
struct NodeSize {
  facet::Box box;
  double thickness = 0;  ///< thickness of the thickest piece

  void add(const facet::Solid& solid) {
    if (solid.vertices.empty()) return;
    box = facet::hull(box, facet::box_of(solid.vertices));
    thickness = std::max(thickness, 2 * inner_radius(solid, middle_of(solid)));
  }

  [[nodiscard]] double width() const {
    double min_width = std::numeric_limits<double>::infinity();
    if (thickness > 0) min_width = thickness;
    for (int axis = 0; axis < 3; ++axis)
      if (box.high[axis] > box.low[axis]) min_width = std::min(min_width, box.high[axis] - box.low[axis]);
    return min_width;
  }
};

Size size_of(const model::Tree& tree, const facet::Faceting& faceting) {
  Size size;
  std::map<std::array<std::uint32_t, 3>, NodeSize> nodes;
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const model::Location& location = tree.primitives[i].location;
    const bool is_of_a_file = location.line != 0;
    nodes[{location.line, location.column, is_of_a_file ? 0 : i}].add(facet::make_solid_at(tree, i, faceting));
  }
  for (const auto& [place, node] : nodes) {
    size.box = facet::hull(size.box, node.box);
    size.min_body_width = std::min(size.min_body_width, node.width());
  }
  if (size.box.empty()) size.box = {glm::dvec3(0), glm::dvec3(0)};
  return size;
}

/// The point of the box nearest to the origin, where doubles are finest.
glm::dvec3 reference_of(const facet::Box& box) { return glm::clamp(glm::dvec3(0), box.low, box.high); }

class BodyMaker {
 public:
  BodyMaker(const glm::dvec3& reference, double diagonal, double unit, double tolerance)
      : reference_(reference), tolerance_(tolerance), planes_(reference, diagonal, unit) {}

  /// Creates the half-spaces of a solid. Appends the body's face index to `face_of` for each face of the solid.
  Body make(const facet::Solid& solid, std::vector<std::uint32_t>& face_of) {
    Body body;
    planes_.begin(footprint_of(solid));
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
    for (const facet::Face& face : solid.faces) {
      const facet::Halfspace halfspace = planes_.add(face.plane);
      const auto [entry, is_new] = known.try_emplace({halfspace.plane, halfspace.positive}, body.faces.size());
      face_of.push_back(entry->second);
      if (is_new) body.faces.push_back({.halfspace = halfspace, .box = {}});
    }
    return body;
  }

  [[nodiscard]] const std::vector<facet::Plane>& planes() const { return planes_.planes(); }

 private:
  [[nodiscard]] Footprint footprint_of(const facet::Solid& solid) const {
    Footprint ball;
    if (solid.vertices.empty()) return ball;
    const glm::dvec3 middle = middle_of(solid);
    double farthest = 0;
    for (const glm::dvec3& vertex : solid.vertices) {
      ball.radius = std::max(ball.radius, glm::distance(middle, vertex));
      farthest = std::max(farthest, glm::length(vertex));
    }
    ball.middle = middle - reference_;
    ball.tolerance = std::min(std::max(part_of_tolerance * tolerance_, rounding * farthest),
                              part_of_thickness * 2 * inner_radius(solid, middle));
    return ball;
  }

  glm::dvec3 reference_;
  double tolerance_;
  FacePlanes planes_;
};

std::vector<std::array<std::uint32_t, 2>> edges_of(const facet::Solid& solid) {
  std::vector<std::array<std::uint32_t, 2>> edges = solid.edges;
  for (const facet::Face& face : solid.faces) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto [low, high] = std::minmax(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
      if (low != high) edges.push_back({low, high});
    }
    if (edges.size() > 2 * Body::most_edges) return {};
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (edges.size() > Body::most_edges) return {};
  return edges;
}

glm::dvec3 twice_area(const facet::Solid& solid, const facet::Face& face) {
  const glm::dvec3 first = solid.vertices[face.corners.front()];
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
    sum += glm::cross(solid.vertices[face.corners[i]] - first, solid.vertices[face.corners[i + 1]] - first);
  return sum;
}

void add_polygons(const facet::Solid& solid, std::span<const std::uint32_t> face_of, Body& body) {
  const auto has_corners = [](const facet::Face& face) { return !face.corners.empty(); };
  if (!std::ranges::all_of(solid.faces, has_corners)) return;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    const facet::Face& face = solid.faces[i];
    const auto first = static_cast<std::uint32_t>(body.corners.size());
    body.corners.insert(body.corners.end(), face.corners.begin(), face.corners.end());
    if (glm::dot(twice_area(solid, face), face.plane.normal) < 0)
      std::ranges::reverse(std::span(body.corners).subspan(first));
    body.polygons.push_back({face_of[i], first, static_cast<std::uint32_t>(face.corners.size())});
  }
}

csg::BoxIndex index_of(const std::vector<Body>& bodies) {
  std::vector<csg::BoxIndex::Entry> entries;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (!bodies[i].box.empty()) entries.push_back({index_box(bodies[i].box), i});
  return csg::BoxIndex(entries);
}

}  // namespace

std::vector<std::uint32_t> Bodies::bodies_meeting(const UnitBox& box) const {
  std::vector<std::uint32_t> found;
  index.meeting(index_box(box), found);
  return found;
}

Bodies make_bodies(const model::Tree& tree, const facet::Faceting& faceting, const Work& work) {
  const Size size = size_of(tree, faceting);
  const double diagonal = size.box.diagonal() > 0 ? size.box.diagonal() : 1.0;
  const double tolerance =
      std::max(finest * diagonal, std::min(coarsest * diagonal, part_of_width * size.min_body_width));
  const glm::dvec3 reference = reference_of(size.box);
  const facet::Box box{size.box.low - reference, size.box.high - reference};
  BodyMaker maker(reference, diagonal, WholePlanes::unit_of(box), tolerance);
  std::vector<Body> bodies;
  std::vector<std::vector<std::uint32_t>> faces_of(tree.primitives.size());
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i)
    bodies.push_back(maker.make(facet::make_solid_at(tree, i, faceting), faces_of[i]));
  WholePlanes planes(maker.planes(), box);
  ExactFaces exact(planes, reference, tolerance, work);
  for (std::uint32_t i = 0; i < tree.primitives.size(); ++i) {
    const facet::Solid solid = facet::make_solid_at(tree, i, faceting);
    bodies[i].edges = edges_of(solid);
    add_polygons(solid, faces_of[i], bodies[i]);
    exact.complete(solid, faces_of[i], bodies[i]);
  }
  csg::BoxIndex index = index_of(bodies);
  return {reference, tolerance, maker.planes(), std::move(planes), std::move(bodies), std::move(index)};
}

}  // namespace csgsim::software::convert
