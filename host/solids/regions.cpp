#include "host/solids/regions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <string_view>

#include "host/solids/flat_faces.h"

namespace csgsim::solids {

namespace {

/// Cost, in steps of work, of adding a face to a region, and of testing a face against the region's final plane.
constexpr std::uint64_t gather_steps = 40;
constexpr std::uint64_t settle_steps = 8;
constexpr std::string_view gathering = "gathering the faces of a plane";

/// Sums over faces that determine a plane.
struct Sums {
  glm::dvec3 vector{0};  ///< sum of area vectors
  glm::dvec3 middle{0};  ///< sum of centres, weighted by area
  double area = 0;

  void operator+=(const Sums& other) {
    vector += other.vector;
    middle += other.middle;
    area += other.area;
  }

  [[nodiscard]] facet::Plane plane() const {
    const glm::dvec3 normal = glm::normalize(vector);
    return {normal, -glm::dot(normal, middle / area)};
  }
};

class RegionGrower {
 public:
  RegionGrower(const Mesh& mesh, const Neighbours& neighbours, double tolerance, const Work& work)
      : mesh_(mesh), neighbours_(neighbours), tolerance_(tolerance), work_(work) {
    regions_.of_face.assign(mesh.faces.size(), none);
    for (const auto& face : mesh.faces) sums_.push_back(face_sums(face));
  }

  Regions operator()() {
    std::vector<std::uint32_t> order(mesh_.faces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return sums_[a].area > sums_[b].area; });
    for (const std::uint32_t face : order) {
      // A region may lose its seed face when its plane is refitted; in that case a region is grown from the seed again.
      while (regions_.of_face[face] == none && glm::length(sums_[face].vector) > 0) grow(face);
    }
    return std::move(regions_);
  }

 private:
  [[nodiscard]] Sums face_sums(const std::vector<std::uint32_t>& face) const {
    Sums sums;
    sums.vector = area_vector(mesh_, face);
    sums.area = glm::length(sums.vector);
    for (const std::uint32_t corner : face) sums.middle += mesh_.points[corner];
    sums.middle *= sums.area / static_cast<double>(face.size());
    return sums;
  }

  /// Maximum distance of a face's corners from the plane.
  [[nodiscard]] double off(std::uint32_t face, const facet::Plane& plane) const {
    double most = 0;
    for (const std::uint32_t corner : mesh_.faces[face]) {
      most = std::max(most, std::abs(glm::dot(plane.normal, mesh_.points[corner]) + plane.offset));
    }
    return most;
  }

  [[nodiscard]] bool fits(std::uint32_t face, const facet::Plane& plane) const {
    return glm::dot(sums_[face].vector, plane.normal) >= 0 && off(face, plane) <= tolerance_;
  }

  void grow(std::uint32_t seed) {
    const auto region = static_cast<std::uint32_t>(regions_.planes.size());
    std::vector<std::uint32_t> members = gather(seed, region);
    Sums sums = total(members);
    // The plane changes while faces are gathered, so the first faces may no longer fit.
    for (bool settled = false; !settled && members.size() > 1; sums = total(members)) {
      work_.charge(settle_steps * members.size(), gathering);
      const facet::Plane plane = sums.plane();
      settled = std::erase_if(members, [&](std::uint32_t face) {
                  if (off(face, plane) <= tolerance_) return false;
                  regions_.of_face[face] = none;
                  return true;
                }) == 0;
    }
    if (members.empty() || glm::length(sums.vector) == 0) {
      members = {seed};
      sums = sums_[seed];
    }
    const facet::Plane plane = sums.plane();
    for (const std::uint32_t face : members) {
      regions_.of_face[face] = region;
      regions_.deviation = std::max(regions_.deviation, off(face, plane));
    }
    regions_.planes.push_back(plane);
  }

  std::vector<std::uint32_t> gather(std::uint32_t seed, std::uint32_t region) {
    std::vector<std::uint32_t> members{seed};
    regions_.of_face[seed] = region;
    Sums sums = sums_[seed];
    for (std::size_t next = 0; next < members.size(); ++next) {
      work_.charge(gather_steps, gathering);
      const std::uint32_t face = members[next];
      for (std::uint32_t side = neighbours_.first_side[face]; side < neighbours_.first_side[face + 1]; ++side) {
        const std::uint32_t beyond = neighbours_.face[side];
        if (beyond == none || regions_.of_face[beyond] != none || !fits(beyond, sums.plane())) continue;
        regions_.of_face[beyond] = region;
        members.push_back(beyond);
        sums += sums_[beyond];
      }
    }
    return members;
  }

  [[nodiscard]] Sums total(const std::vector<std::uint32_t>& members) const {
    Sums sums;
    for (const std::uint32_t face : members) sums += sums_[face];
    return sums;
  }

  const Mesh& mesh_;
  const Neighbours& neighbours_;
  double tolerance_;
  const Work& work_;
  std::vector<Sums> sums_;  ///< sums of each face
  Regions regions_;
};

}  // namespace

Regions find_regions(const Mesh& mesh, const Neighbours& neighbours, double tolerance, const Work& work) {
  return RegionGrower(mesh, neighbours, tolerance, work)();
}

}  // namespace csgsim::solids
