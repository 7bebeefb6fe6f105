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

/// Step of the grid, in model units, to which OpenSCAD truncates corners when it combines solids.
constexpr double point_grid = 0x1p-20;

class FaceCutter {
 public:
  FaceCutter(const Mesh& mesh, const MeshPlacement& placement)
      : mesh_(mesh),
        placement_(placement),
        is_reversed_((glm::determinant(placement.transform) < 0) != placement.is_reversed) {}

  /// Returns the triangles of a face; empty if the face crosses itself.
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
    const glm::dvec3 moved(placement_.transform * glm::dvec4(point, 1));
    return glm::vec3(placement_.meets_others ? glm::trunc(moved / point_grid) * point_grid : moved);
  }

  const Mesh& mesh_;
  const MeshPlacement& placement_;
  bool is_reversed_;
};

}  // namespace

BentFaces cut_bent_faces(NumberedMesh& numbered, double tolerance, const MeshPlacement& placement) {
  BentFaces bent;
  const FaceCutter cutting(numbered.mesh, placement);
  std::vector<Face> faces;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < numbered.mesh.faces.size(); ++i) {
    Face& face = numbered.mesh.faces[i];
    const std::uint32_t number = numbered.face_numbers[i];
    const double off = face.size() > 3 ? max_plane_distance(numbered.mesh, face) : 0;
    std::vector<Face> parts;
    if (off > tolerance) {
      parts = cutting(face);
      if (bent.count++ == 0) bent.first = number;
      bent.max_deviation = std::max(bent.max_deviation, off);
      if (parts.empty() && !bent.first_different) bent.first_different = number;
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
