#include "host/convex/merge.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

constexpr std::string_view merging = "merging convex pieces";

/// Cost of comparing the boxes of two polytopes.
constexpr std::uint64_t pair_steps = 4;

/// A face of a polytope, sorted by its plane.
struct Entry {
  std::uint32_t plane = 0;
  bool negative = false;
  std::uint32_t polytope = 0;

  bool operator<(const Entry& other) const {
    return std::tie(plane, negative, polytope) < std::tie(other.plane, other.negative, other.polytope);
  }
};

class PolytopeMerger {
 public:
  PolytopeMerger(std::vector<Polytope>& polytopes, const facet::PlaneTable& planes, const Work& work)
      : polytopes_(polytopes), planes_(planes), work_(work) {}

  void operator()() {
    while (pass()) std::erase_if(polytopes_, [](const Polytope& polytope) { return polytope.empty(); });
  }

 private:
  /// Visits every plane once. Returns whether any polytopes were merged.
  bool pass() {
    boxes_.clear();
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < polytopes_.size(); ++i) {
      boxes_.push_back(box_of(polytopes_[i]));
      for (const Face& face : polytopes_[i].faces) {
        entries.push_back({face.halfspace.plane, !face.halfspace.positive, static_cast<std::uint32_t>(i)});
      }
    }
    std::sort(entries.begin(), entries.end());
    bool joined = false;
    for (auto begin = entries.begin(); begin != entries.end();) {
      const auto end = std::find_if(begin, entries.end(), [&](const Entry& one) { return one.plane != begin->plane; });
      const auto middle = std::find_if(begin, end, [](const Entry& one) { return one.negative; });
      for (auto one = begin; one != middle; ++one) {
        work_.charge(pair_steps * static_cast<std::uint64_t>(end - middle), merging);
        for (auto other = middle; other != end; ++other) joined |= join(one->polytope, other->polytope, one->plane);
      }
      begin = end;
    }
    return joined;
  }

  /// Merges two polytopes into the first if their union is convex.
  bool join(std::uint32_t one, std::uint32_t other, std::uint32_t plane) {
    Polytope& first = polytopes_[one];
    Polytope& second = polytopes_[other];
    if (common(boxes_[one], boxes_[other]).empty()) return false;
    work_.charge(first.faces.size() * second.vertices.size() + second.faces.size() * first.vertices.size(), merging);
    if (!has_face(first, {plane, true}) || !has_face(second, {plane, false})) return false;
    if (!holds(first, second, plane) || !holds(second, first, plane)) return false;
    // The other half-spaces contain both polytopes, so each polytope is the intersection of these half-spaces with its
    // side of the plane.
    std::vector<facet::Halfspace> halfspaces;
    for (const Polytope* part : {&first, &second}) {
      for (const Face& face : part->faces) {
        if (face.halfspace.plane != plane) halfspaces.push_back(face.halfspace);
      }
    }
    const facet::Box box = hull(boxes_[one], boxes_[other]);
    Polytope both = intersection(box, halfspaces, planes_, work_);
    if (both.empty()) return false;
    first = std::move(both);
    second = {};
    boxes_[one] = box;
    boxes_[other] = {};
    return true;
  }

  static bool has_face(const Polytope& polytope, facet::Halfspace halfspace) {
    return std::any_of(polytope.faces.begin(), polytope.faces.end(),
                       [&](const Face& face) { return face.halfspace == halfspace; });
  }

  /// Whether the half-spaces of one polytope, except those of the plane, contain the other.
  [[nodiscard]] bool holds(const Polytope& one, const Polytope& other, std::uint32_t plane) const {
    return std::all_of(one.faces.begin(), one.faces.end(), [&](const Face& face) {
      if (face.halfspace.plane == plane) return true;
      const facet::Plane wall = outward_plane(face.halfspace, planes_);
      return std::all_of(other.vertices.begin(), other.vertices.end(),
                         [&](const glm::dvec3& vertex) { return wall.height(vertex) <= tolerance(planes_); });
    });
  }

  std::vector<Polytope>& polytopes_;
  const facet::PlaneTable& planes_;
  const Work& work_;
  std::vector<facet::Box> boxes_;  ///< boxes of the polytopes
};

}  // namespace

void merge(std::vector<Polytope>& polytopes, const facet::PlaneTable& planes, const Work& work) {
  PolytopeMerger(polytopes, planes, work)();
}

}  // namespace csgsim::convex
