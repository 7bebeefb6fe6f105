#include "host/convex/near_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/convex/face_polygon.h"
#include "hw/base/messages.h"

namespace csgsim::convex {

namespace {

/// A direction along which planes are sorted; models have no symmetry with respect to it.
constexpr glm::dvec3 sorting{0.4142, 0.5918, 0.6914};
constexpr double sorting_offset = 0.7321;

/// Maximum difference between the sort positions of nearly equal planes.
constexpr double window = near_normals * (sorting.x + sorting.y + sorting.z) + near_offsets * sorting_offset;

/// A plane in one of its two orientations.
struct Oriented {
  double place = 0;
  std::uint32_t plane = 0;
  bool is_reversed = false;

  /// Orders by position, then by plane; the reversed orientation of a plane comes last.
  bool operator<(const Oriented& other) const {
    if (place != other.place) return place < other.place;
    return plane != other.plane ? plane < other.plane : !is_reversed && other.is_reversed;
  }
};

/// Reverses the orientation of sorted planes, and returns them in sorted order.
std::vector<Oriented> reversed(const std::vector<Oriented>& planes) {
  std::vector<Oriented> all;
  all.reserve(planes.size());
  for (std::size_t end = planes.size(); end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && planes[begin - 1].place == planes[begin].place) --begin;
    for (std::size_t i = begin; i < end; ++i) all.push_back({-planes[i].place, planes[i].plane, true});
    end = begin;
  }
  return all;
}

std::vector<Oriented> sorted(const facet::PlaneTable& planes) {
  std::vector<Oriented> one_way;
  one_way.reserve(planes.planes().size());
  for (const facet::Plane& plane : planes.planes()) {
    const auto number = static_cast<std::uint32_t>(one_way.size());
    const double place = glm::dot(plane.normal, sorting) + plane.offset / planes.diagonal() * sorting_offset;
    one_way.push_back({place, number, false});
  }
  std::sort(one_way.begin(), one_way.end());
  const std::vector<Oriented> other_way = reversed(one_way);
  std::vector<Oriented> all(2 * one_way.size());
  std::merge(one_way.begin(), one_way.end(), other_way.begin(), other_way.end(), all.begin());
  return all;
}

/// A second direction: the normals' components along it distinguish planes with nearly equal sort positions. The
/// components are in single precision, so that several fit a vector register.
constexpr glm::dvec3 discriminator{0.7333, -0.5477, 0.4019};
constexpr float discriminator_window =
    static_cast<float>(near_normals * (discriminator.x - discriminator.y + discriminator.z)) + 4e-7F;

std::vector<float> discriminating_values(const std::vector<Oriented>& all, const facet::PlaneTable& planes) {
  std::vector<float> values;
  values.reserve(all.size());
  for (const Oriented& one : all) {
    const auto value = static_cast<float>(glm::dot(planes.planes()[one.plane].normal, discriminator));
    values.push_back(one.is_reversed ? -value : value);
  }
  return values;
}

/// Calls visit(j) for each j in [begin, end) for which values[j] differs from `value` by at most discriminator_window.
template <class Visit>
void for_near_values(const std::vector<float>& values, float value, std::size_t begin, std::size_t end,
                     const Visit& visit) {
  constexpr std::size_t at_once = 16;
  for (std::size_t i = begin; i < end;) {
    const std::size_t stop = std::min(i + at_once, end);
    if (stop - i == at_once) {
      unsigned any = 0;
      for (std::size_t k = 0; k < at_once; ++k)
        any |= std::abs(values[i + k] - value) <= discriminator_window ? 1U : 0U;
      if (any == 0) {
        i = stop;
        continue;
      }
    }
    for (; i < stop; ++i) {
      if (std::abs(values[i] - value) <= discriminator_window) visit(i);
    }
  }
}

/// The primitives that have a face in each plane.
class Users {
 public:
  explicit Users(const facet::Geometry& geometry) : begins_(geometry.planes.planes().size() + 1) {
    for (const facet::Convex& solid : geometry.solids) {
      for (const facet::Halfspace& halfspace : solid.halfspaces) ++begins_[halfspace.plane];
    }
    std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), std::uint32_t{0});
    users_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for (std::uint32_t solid = 0; solid < geometry.solids.size(); ++solid) {
      for (const facet::Halfspace& halfspace : geometry.solids[solid].halfspaces)
        users_[next[halfspace.plane]++] = solid;
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t plane) const {
    return std::span(users_).subspan(begins_[plane], begins_[plane + 1] - begins_[plane]);
  }

 private:
  std::vector<std::uint32_t> begins_;  ///< first index into users_ for each plane
  std::vector<std::uint32_t> users_;
};

bool are_near(const facet::Plane& one, const facet::Plane& other, double sign, double diagonal) {
  const glm::dvec3 apart = glm::abs(one.normal - sign * other.normal);
  const double tilt = std::max({apart.x, apart.y, apart.z});
  const double offset = std::abs(one.offset - sign * other.offset) / diagonal;
  const bool is_parallel = tilt <= facet::coincidence_tolerance;
  return tilt <= near_normals && offset <= (is_parallel ? near_parallel_offsets : near_offsets);
}

/// The number, in file order, of each primitive's node.
std::vector<std::uint32_t> node_numbers(const model::Tree& tree) {
  std::vector<std::uint32_t> nodes;
  std::uint32_t node = 0;
  for (const model::Primitive& primitive : tree.primitives) {
    if (!primitive.continues) ++node;
    nodes.push_back(node);
  }
  return nodes;
}

using Outline = std::vector<glm::dvec2>;

/// Whether the outlines overlap by more than `least` along every direction perpendicular to an edge of the first
/// outline.
bool overlap_across(const Outline& one, const Outline& other, double least) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const glm::dvec2 edge = one[(i + 1) % one.size()] - one[i];
    const double length = glm::length(edge);
    if (!(length > 0.0)) continue;
    const glm::dvec2 across = glm::dvec2(edge.y, -edge.x) / length;
    const auto range = [&](const Outline& outline) {
      std::pair<double, double> all{glm::dot(across, outline[0]), glm::dot(across, outline[0])};
      for (const glm::dvec2& corner : outline) {
        all.first = std::min(all.first, glm::dot(across, corner));
        all.second = std::max(all.second, glm::dot(across, corner));
      }
      return all;
    };
    const auto [low, high] = range(one);
    const auto [other_low, other_high] = range(other);
    if (std::min(high, other_high) - std::max(low, other_low) <= least) return false;
  }
  return true;
}

class PairSearch {
 public:
  PairSearch(const model::Tree& tree, const facet::Geometry& geometry)
      : tree_(tree), geometry_(geometry), users_(geometry), nodes_(node_numbers(tree)) {}

  NearFaces find() {
    const std::vector<Oriented> planes = sorted(geometry_.planes);
    const std::vector<float> values = discriminating_values(planes, geometry_.planes);
    std::uint64_t left = max_near_faces + 16 * planes.size();
    std::size_t end = 0;
    for (std::size_t i = 0; i < planes.size() && !found_.is_incomplete; ++i) {
      end = std::max(end, i + 1);
      while (end < planes.size() && planes[end].place - planes[i].place <= window) ++end;
      const std::size_t last = i + 1 + std::min<std::uint64_t>(left, end - (i + 1));
      for_near_values(values, values[i], i + 1, last, [&](std::size_t j) {
        // A pair of two reversed planes mirrors a pair that is tested anyway.
        if (!found_.is_incomplete && !(planes[i].is_reversed && planes[j].is_reversed)) test_pair(planes[i], planes[j]);
      });
      left -= last - (i + 1);
      if (last < end) found_.is_incomplete = true;
    }
    return counted();
  }

 private:
  NearFaces counted() {
    found_.pairs = pairs_.size();
    return found_;
  }

  void test_pair(const Oriented& one, const Oriented& other) {
    const std::vector<facet::Plane>& planes = geometry_.planes.planes();
    if (one.plane == other.plane) return;
    const double sign = one.is_reversed == other.is_reversed ? 1.0 : -1.0;
    if (!are_near(planes[one.plane], planes[other.plane], sign, geometry_.planes.diagonal())) return;
    for (const std::uint32_t first : users_[one.plane]) {
      for (const std::uint32_t second : users_[other.plane]) {
        if (++faces_tested_ > max_near_faces) found_.is_incomplete = true;
        if (found_.is_incomplete) return;
        const auto [low, high] = std::minmax(first, second);
        if (nodes_[low] == nodes_[high] || !may_meet(low, high) || pairs_.contains({nodes_[low], nodes_[high]}))
          continue;
        if (faces_overlap(first, one.plane, second, other.plane)) add(low, high);
      }
    }
  }

  void add(std::uint32_t low, std::uint32_t high) {
    if (pairs_.empty() || std::array{low, high} < found_.first) found_.first = {low, high};
    pairs_.insert({nodes_[low], nodes_[high]});
  }

  [[nodiscard]] double slack() const { return 2.0 * near_offsets * geometry_.planes.diagonal(); }

  /// Whether both primitives are solids of the file with overlapping boxes.
  [[nodiscard]] bool may_meet(std::uint32_t one, std::uint32_t other) const {
    const facet::Box& box = geometry_.solids[one].box;
    const bool are_of_file = tree_.primitives[one].section == model::no_index &&  //
                             tree_.primitives[other].section == model::no_index;
    return are_of_file && !common({box.low - slack(), box.high + slack()}, geometry_.solids[other].box).empty();
  }

  bool faces_overlap(std::uint32_t one, std::uint32_t in, std::uint32_t other, std::uint32_t in_other) {
    const auto [right, up] = plane_axes(geometry_.planes.planes()[in].normal);
    const Outline a = outline(one, in, right, up);
    const Outline b = outline(other, in_other, right, up);
    if (a.empty() || b.empty()) return false;
    // Faces that are adjacent, or smaller than the rounding error, do not overlap.
    return overlap_across(a, b, slack()) && overlap_across(b, a, slack());
  }

  /// The outline of a primitive's face in a plane; empty if the primitive only touches the plane.
  Outline outline(std::uint32_t primitive, std::uint32_t plane, const glm::dvec3& right, const glm::dvec3& up) {
    const auto [found, is_new] = polygons_.try_emplace(std::uint64_t{primitive} << 32U | plane);
    if (is_new) found->second = face_polygon(geometry_.solids[primitive], plane, geometry_.planes);
    Outline outline;
    outline.reserve(found->second.size());
    for (const glm::dvec3& point : found->second) outline.emplace_back(glm::dot(right, point), glm::dot(up, point));
    return outline;
  }

  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  Users users_;
  std::vector<std::uint32_t> nodes_;
  std::unordered_map<std::uint64_t, std::vector<glm::dvec3>> polygons_;  ///< polygons of faces, by primitive and plane
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  std::uint64_t faces_tested_ = 0;
  NearFaces found_;
};

}  // namespace

NearFaces near_faces(const model::Tree& tree, const facet::Geometry& geometry) {
  return PairSearch(tree, geometry).find();
}

void warn_of_near_faces(const model::Tree& tree, const facet::Geometry& geometry, bool is_snapped) {
  const NearFaces found = near_faces(tree, geometry);
  if (found.pairs == 0) return;
  const std::string others =
      found.pairs == 1 && !found.is_incomplete
          ? ""
          : fmt::format(" ({}{} more such pairs)", found.is_incomplete ? "at least " : "", found.pairs - 1);
  const std::string first = model::location_text(tree, found.first[0]);
  const std::string second = model::location_text(tree, found.first[1]);
  report_line(
      fmt::format("{}: warning: a face of this solid and a face of {} are nearly, but not exactly, coplanar{}; "
                  "specks or a thin skin may be visible: {}let one solid reach well into the other",
                  first, second, others, is_snapped ? "" : "use --snap, or "));
}

}  // namespace csgsim::convex
