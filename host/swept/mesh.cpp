#include "host/swept/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <span>

#include "host/swept/filter.h"
#include "host/swept/quadtree.h"
#include "host/swept/spine.h"
#include "hw/base/error.h"

namespace csgsim::swept {

namespace {

class Collector : public Output {
 public:
  explicit Collector(Patchwork& made) : made_(made) {}

  std::uint32_t new_vertex() override {
    made_.points.emplace_back(0);
    return static_cast<std::uint32_t>(made_.points.size() - 1);
  }
  void vertex(std::uint32_t number, const glm::dvec3& point) override { made_.points[number] = point; }
  void element(const Square& /*square*/, std::span<const std::uint32_t> corners) override {
    made_.elements.emplace_back(corners.begin(), corners.end());
  }

 private:
  Patchwork& made_;
};

void repair_patch(Surface& surface, std::size_t column, std::size_t row, const WireFrame* frame,
                  const Accuracy& accuracy, Repair repair, Patchwork& made, Output& output) {
  const std::unique_ptr<Stream> stream = surface.subdivide(column, row, accuracy, made.subdivision);
  std::optional<PatchEdges> edges;
  if (frame != nullptr) edges = frame->edges(column, row);
  const PatchEdges* const known = edges ? &*edges : nullptr;
  if (repair == Repair::filter) {
    filter(*stream, known, output, made.repair);
  } else {
    repair_by_quadtree(*stream, known, output, made.repair);
  }
}

std::optional<WireFrame> make_wire_frame(Surface& surface, const Accuracy& accuracy, Patchwork& made, Output& output) {
  const bool is_alone = surface.columns() * surface.rows() == 1 && !surface.wraps_columns() && !surface.wraps_rows();
  if (is_alone) return std::nullopt;
  std::optional<WireFrame> frame(std::in_place, surface, accuracy, made.wiring, output);
  made.wire_vertices = frame->vertex_count();
  made.repair.vertices += frame->vertex_count();
  made.repair.snaps += frame->snaps();
  return frame;
}

Patchwork make_patchwork(Surface& surface, const Accuracy& accuracy, Repair repair, std::optional<WireFrame>& frame) {
  Patchwork made;
  Collector collector(made);
  frame = make_wire_frame(surface, accuracy, made, collector);
  for (std::size_t row = 0; row < surface.rows(); ++row) {
    for (std::size_t column = 0; column < surface.columns(); ++column)
      repair_patch(surface, column, row, frame ? &*frame : nullptr, accuracy, repair, made, collector);
  }
  return made;
}

using Face = std::vector<std::uint32_t>;

/// Collects the faces of a swept solid; a base or cap of size 0 becomes one vertex.
class SolidBuilder {
 public:
  SolidBuilder(const Patchwork& patchwork, bool is_clockwise)
      : points_(patchwork.points), is_clockwise_(is_clockwise), same_(points_.size()) {
    for (std::uint32_t i = 0; i < same_.size(); ++i) same_[i] = i;
  }

  void join(const Face& ring) {
    for (const std::uint32_t vertex : ring) same_[vertex] = ring.front();
  }

  /// Adds a face. A base or cap is planar apart from rounding, and need not be convex.
  void add(Face face, bool is_end = false) {
    for (std::uint32_t& vertex : face) vertex = same_[vertex];
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() < 3) return;
    if (is_clockwise_) std::ranges::reverse(face);
    if (is_end || is_plane(face)) {
      faces_.push_back(std::move(face));
    } else {
      cut(face);
    }
  }

  solids::Mesh mesh() {
    solids::Mesh made;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> is_used(points_.size(), false);
    for (const Face& face : faces_) {
      for (const std::uint32_t vertex : face) is_used[vertex] = true;
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      numbers.push_back(static_cast<std::uint32_t>(made.points.size()));
      if (is_used[i]) made.points.push_back(points_[i]);
    }
    made.faces = std::move(faces_);
    for (Face& face : made.faces) {
      for (std::uint32_t& vertex : face) vertex = numbers[vertex];
    }
    return made;
  }

 private:
  /// Newell's normal, with twice the area as its length.
  [[nodiscard]] glm::dvec3 normal(const Face& face) const {
    glm::dvec3 sum(0);
    const glm::dvec3& origin = points_[face.front()];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += glm::cross(points_[face[i]] - origin, points_[face[i + 1]] - origin);
    return sum;
  }

  [[nodiscard]] bool is_plane(const Face& face) const {
    if (face.size() == 3) return true;
    const glm::dvec3 across = normal(face);
    const double length = glm::length(across);
    constexpr double nearly = 1e-13;  // below the tolerance that solids::convex_pieces() uses for bent faces
    return std::ranges::all_of(face, [&](std::uint32_t vertex) {
      const glm::dvec3& point = points_[vertex];
      const double reach = glm::length(point) + glm::length(points_[face.front()]);
      return std::abs(glm::dot(point - points_[face.front()], across)) <= nearly * reach * length;
    });
  }

  /// Cuts a quadrilateral along its shorter diagonal, and larger faces into a fan around their centre.
  void cut(const Face& face) {
    if (face.size() == 4) {
      const std::size_t first =
          glm::distance(points_[face[0]], points_[face[2]]) <= glm::distance(points_[face[1]], points_[face[3]]) ? 0
                                                                                                                 : 1;
      faces_.push_back({face[first], face[first + 1], face[first + 2]});
      faces_.push_back({face[first], face[first + 2], face[(first + 3) % 4]});
      return;
    }
    glm::dvec3 middle(0);
    for (const std::uint32_t vertex : face) middle += points_[vertex] / static_cast<double>(face.size());
    const auto centre = static_cast<std::uint32_t>(points_.size());
    points_.push_back(middle);
    same_.push_back(centre);
    for (std::size_t i = 0; i < face.size(); ++i) faces_.push_back({centre, face[i], face[(i + 1) % face.size()]});
  }

  std::vector<glm::dvec3> points_;
  bool is_clockwise_;
  std::vector<std::uint32_t> same_;
  std::vector<Face> faces_;
};

/// The vertices below the first row, or above the last, in the order of the contour.
Face ring(const WireFrame& frame, std::size_t columns, std::size_t joint) {
  Face vertices;
  for (std::size_t column = 0; column < columns; ++column) {
    const WireEdge& edge = frame.along_u(column, joint);
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) vertices.push_back(edge[i].number);
  }
  return vertices;
}

}  // namespace

Patchwork make_patchwork(Surface& surface, const Accuracy& accuracy, Repair repair) {
  std::optional<WireFrame> frame;
  return make_patchwork(surface, accuracy, repair, frame);
}

SweptSolid make_swept_solid(const Sweep& sweep, const Accuracy& accuracy, Repair repair) {
  const std::unique_ptr<Surface> surface = make_surface(sweep);
  std::optional<WireFrame> frame;
  SweptSolid solid;
  solid.patchwork = make_patchwork(*surface, accuracy, repair, frame);
  SolidBuilder closing(solid.patchwork, twice_signed_area(sweep.contour) < 0);
  if (!surface->wraps_rows()) {
    const Spine spine(sweep);
    for (const std::size_t joint : {std::size_t{0}, surface->rows()}) {
      Face face = ring(*frame, surface->columns(), joint);
      if (spine.joint(joint).is_point()) {
        closing.join(face);
        continue;
      }
      if (joint == 0) std::ranges::reverse(face);
      closing.add(std::move(face), true);
    }
  }
  for (const Face& element : solid.patchwork.elements) closing.add(element);
  solid.mesh = closing.mesh();
  return solid;
}

}  // namespace csgsim::swept
