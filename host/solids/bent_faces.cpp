#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <utility>

#include "host/solids/check.h"
#include "host/solids/flat_faces.h"
#include "host/solids/tessellation.h"

namespace csgsim::solids {

namespace {

using Face = std::vector<std::uint32_t>;

/// Before solids meet, corners are moved towards 0 to a grid of this step.
constexpr double point_grid = 0x1p-20;

class Cutting {
 public:
  Cutting(const Mesh& mesh, const Standing& standing)
      : mesh_(mesh),
        standing_(standing),
        is_reversed_((glm::determinant(standing.transform) < 0) != standing.runs_back) {}

  /// None if the face crosses itself.
  [[nodiscard]] std::vector<Face> operator()(Face face) const {
    if (is_reversed_) std::ranges::reverse(face);
    std::vector<glm::vec3> outline;
    for (const std::uint32_t corner : face) outline.push_back(placed(mesh_.points[corner]));
    std::vector<Face> parts;
    for (const OutlineTriangle& triangle : tessellate(outline).value_or(std::vector<OutlineTriangle>())) {
      Face& part = parts.emplace_back();
      for (const std::uint32_t corner : triangle) part.push_back(face[corner]);
      if (is_reversed_) std::ranges::reverse(part);
    }
    return parts;
  }

 private:
  [[nodiscard]] glm::vec3 placed(const glm::dvec3& point) const {
    const glm::dvec3 moved(standing_.transform * glm::dvec4(point, 1));
    return glm::vec3(standing_.meets_others ? glm::trunc(moved / point_grid) * point_grid : moved);
  }

  const Mesh& mesh_;
  const Standing& standing_;
  bool is_reversed_;
};

}  // namespace

BentFaces cut_bent_faces(Numbered& numbered, double tolerance, const Standing& standing) {
  BentFaces bent;
  const Cutting cutting(numbered.mesh, standing);
  std::vector<Face> faces;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < numbered.mesh.faces.size(); ++i) {
    Face& face = numbered.mesh.faces[i];
    const std::uint32_t number = numbered.face_numbers[i];
    const double off = face.size() > 3 ? off_plane(numbered.mesh, face) : 0;
    std::vector<Face> parts;
    if (off > tolerance) {
      parts = cutting(face);
      if (bent.count++ == 0) bent.first = number;
      bent.most_off = std::max(bent.most_off, off);
      if (parts.empty() && !bent.unlike) bent.unlike = number;
    }
    if (parts.empty()) parts.push_back(std::move(face));
    numbers.insert(numbers.end(), parts.size(), number);
    std::move(parts.begin(), parts.end(), std::back_inserter(faces));
  }
  numbered.mesh.faces = std::move(faces);
  numbered.face_numbers = std::move(numbers);
  return bent;
}

}  // namespace csgsim::solids
