#include "sim/software/convert/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "sim/software/convert/sets.h"

namespace csgsim::software::convert {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A side of a triangle.
struct HalfEdge {
  std::uint32_t low = 0;  ///< its ends
  std::uint32_t high = 0;
  bool is_forward = false;   ///< from low to high
  std::uint32_t number = 0;  ///< three a triangle, each from the corner of that number
  double angle = 0;          ///< in which the triangle is seen along the edge, if there are several

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> line() const { return {low, high}; }
};

std::uint32_t next_corner(std::uint32_t number) { return number % 3 == 2 ? number - 2 : number + 1; }

class Pairing {
 public:
  Pairing(const Surface& surface, const Outlines& outlines)
      : surface_(surface), outlines_(outlines), others_(3 * surface.triangles.size(), none) {}

  /// Of each half-edge, the one that it is joined to.
  std::vector<std::uint32_t> operator()() {
    std::vector<HalfEdge> edges;
    edges.reserve(others_.size());
    for (std::uint32_t i = 0; i < others_.size(); ++i) {
      const std::uint32_t from = surface_.triangles[i / 3][i % 3];
      const std::uint32_t to = surface_.triangles[i / 3][(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to, i});
    }
    std::ranges::sort(edges, {}, [](const HalfEdge& edge) { return std::tuple(edge.low, edge.high, edge.number); });
    for (std::size_t begin = 0; begin < edges.size();) {
      std::size_t end = begin;
      while (end < edges.size() && edges[end].line() == edges[begin].line()) ++end;
      pair(std::span(edges).subspan(begin, end - begin));
      begin = end;
    }
    return std::move(others_);
  }

 private:
  void join(const HalfEdge& one, const HalfEdge& other) {
    others_[one.number] = other.number;
    others_[other.number] = one.number;
  }

  /// Around an edge, from a triangle that runs forward clockwise through the solid to the next that runs back.
  void pair(std::span<HalfEdge> edges) {
    const auto forward = std::ranges::count_if(edges, &HalfEdge::is_forward);
    if (2 * forward != static_cast<std::ptrdiff_t>(edges.size()))
      throw std::logic_error("the boundary of the model is not closed");
    if (edges.size() == 2) {
      join(edges[0], edges[1]);
      return;
    }
    find_angles(edges);
    std::ranges::sort(edges, [](const HalfEdge& one, const HalfEdge& other) {
      return one.angle != other.angle ? one.angle > other.angle : one.is_forward > other.is_forward;
    });
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < 2 * edges.size(); ++i) {
      const std::size_t at = i % edges.size();
      if (others_[edges[at].number] != none) continue;
      if (edges[at].is_forward) {
        open.push_back(at);
      } else if (!open.empty()) {
        join(edges[open.back()], edges[at]);
        open.pop_back();
      }
    }
  }

  void find_angles(std::span<HalfEdge> edges) const {
    const glm::dvec3 way = outlines_.points[edges.front().high] - outlines_.points[edges.front().low];
    if (way == glm::dvec3(0)) return;  // any pairing is as good
    const glm::dvec3 along = glm::normalize(way);
    glm::dvec3 across(0);
    for (HalfEdge& edge : edges) {
      const glm::dvec3 outward = outlines_.outlines[surface_.outlines[edge.number / 3]].outward;
      const glm::dvec3 inner = edge.is_forward ? glm::cross(outward, along) : glm::cross(along, outward);
      if (across == glm::dvec3(0)) across = inner;
      edge.angle = std::atan2(glm::dot(glm::cross(across, inner), along), glm::dot(across, inner));
    }
  }

  const Surface& surface_;
  const Outlines& outlines_;
  std::vector<std::uint32_t> others_;
};

/// Corners that are joined along edges share a point, others do not.
void part_points(Surface& surface, const std::vector<std::uint32_t>& others) {
  Sets corners(others.size());
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    corners.join(i, next_corner(others[i]));
    corners.join(next_corner(i), others[i]);
  }
  std::vector<std::uint32_t> numbers(others.size(), none);
  std::vector<glm::dvec3> points;
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    std::uint32_t& number = numbers[corners.find(i)];
    std::uint32_t& corner = surface.triangles[i / 3][i % 3];
    if (number == none) {
      number = static_cast<std::uint32_t>(points.size());
      points.push_back(surface.points[corner]);
    }
    corner = number;
  }
  surface.points = std::move(points);
}

/// Takes out triangles that stand back to back on the same three points, with nothing between them.
void cancel_triangles(Surface& surface) {
  using Corners = std::array<std::uint32_t, 3>;
  std::map<Corners, std::vector<std::size_t>> known;
  const auto turned = [](Triangle triangle) {
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    return triangle;
  };
  std::vector<bool> is_out(surface.triangles.size(), false);
  bool any = false;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle triangle = turned(surface.triangles[i]);
    const auto back = known.find({triangle[0], triangle[2], triangle[1]});
    if (back != known.end() && !back->second.empty()) {
      is_out[i] = is_out[back->second.back()] = any = true;
      back->second.pop_back();
    } else {
      known[triangle].push_back(i);
    }
  }
  if (!any) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (is_out[i]) continue;
    surface.triangles[kept] = surface.triangles[i];
    surface.outlines[kept++] = surface.outlines[i];
  }
  surface.triangles.resize(kept);
  surface.outlines.resize(kept);
}

Surface surface_of(const Outlines& outlines) {
  Surface surface{outlines.points, {}, {}};
  for (std::uint32_t i = 0; i < outlines.outlines.size(); ++i) {
    const std::vector<Triangle> triangles = triangulate(outlines.points, outlines.outlines[i]);
    surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
    surface.outlines.resize(surface.triangles.size(), i);
  }
  cancel_triangles(surface);
  part_points(surface, Pairing(surface, outlines)());
  return surface;
}

/// Puts a point in the middle of each side of the outlines that is that of several edges between the same points of the
/// surface, which is so where a solid touches itself along an edge and hangs together at both of its ends. Whether
/// there was any.
bool halve_repeated(const Surface& surface, Outlines& outlines) {
  std::vector<Side> sides;
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({triangle[i], triangle[(i + 1) % 3]});
  std::ranges::sort(sides);
  using Line = std::pair<std::array<double, 3>, std::array<double, 3>>;
  const auto line_of = [](const glm::dvec3& one, const glm::dvec3& other) {
    const std::array<double, 3> a{one.x, one.y, one.z};
    const std::array<double, 3> b{other.x, other.y, other.z};
    return Line{std::min(a, b), std::max(a, b)};
  };
  std::map<Line, std::uint32_t> middles;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i] != sides[i - 1]) continue;
    const glm::dvec3& one = surface.points[sides[i][0]];
    const glm::dvec3& other = surface.points[sides[i][1]];
    const auto [entry, is_new] = middles.try_emplace(line_of(one, other), 0);
    if (!is_new) continue;
    entry->second = static_cast<std::uint32_t>(outlines.points.size());
    outlines.points.push_back((one + other) / 2.0);
  }
  if (middles.empty()) return false;
  for (Outline& outline : outlines.outlines) {
    std::vector<Side> halved;
    for (const Side& side : outline.sides) {
      const auto middle = middles.find(line_of(outlines.points[side[0]], outlines.points[side[1]]));
      if (middle == middles.end()) {
        halved.push_back(side);
      } else {
        halved.push_back({side[0], middle->second});
        halved.push_back({middle->second, side[1]});
      }
    }
    outline.sides = std::move(halved);
  }
  return true;
}

}  // namespace

Surface make_surface(const Outlines& outlines) {
  constexpr int most_rounds = 4;
  Outlines parted = outlines;
  Surface surface = surface_of(parted);
  for (int round = 0; round < most_rounds && halve_repeated(surface, parted); ++round) surface = surface_of(parted);
  return surface;
}

Measures measure(const Surface& surface) {
  Measures measures;
  Sets points(surface.points.size());
  const glm::dvec3 origin = surface.points.empty() ? glm::dvec3(0) : surface.points.front();
  for (const Triangle& triangle : surface.triangles) {
    const glm::dvec3 a = surface.points[triangle[0]] - origin;
    const glm::dvec3 b = surface.points[triangle[1]] - origin;
    const glm::dvec3 c = surface.points[triangle[2]] - origin;
    measures.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    measures.area += glm::length(glm::cross(b - a, c - a)) / 2.0;
    points.join(triangle[0], triangle[1]);
    points.join(triangle[1], triangle[2]);
  }
  for (std::uint32_t i = 0; i < surface.points.size(); ++i)
    if (points.find(i) == i) ++measures.shells;
  const auto triangles = static_cast<std::int64_t>(surface.triangles.size());
  measures.euler = static_cast<std::int64_t>(surface.points.size()) - triangles / 2;
  return measures;
}

}  // namespace csgsim::software::convert
