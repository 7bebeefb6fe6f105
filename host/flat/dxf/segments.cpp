#include "host/flat/dxf/segments.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "host/flat/clipping.h"
#include "hw/base/error.h"

namespace csgsim::flat::dxf {

namespace {

constexpr double step = 1.0 / 1024;

using Segment = std::array<std::uint32_t, 2>;

/// Traces chains of segments, and uses each segment once.
class Tracer {
 public:
  Tracer(const std::vector<Segment>& segments, std::size_t vertices)
      : segments_(segments), used_(segments.size(), false), at_(vertices), first_(vertices, 0), left_(vertices, 0) {
    for (std::uint32_t segment = 0; segment < segments.size(); ++segment) {
      for (const std::uint32_t vertex : segments[segment]) {
        at_[vertex].push_back(segment);
        ++left_[vertex];
      }
    }
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) mark_if_loose(vertex);
  }

  /// The vertices of all open chains.
  std::vector<std::vector<std::uint32_t>> open() {
    std::vector<std::vector<std::uint32_t>> chains;
    while (!loose_.empty()) {
      const std::uint32_t segment = *loose_.begin();
      chains.push_back(trace(segment, left_[segments_[segment][0]] == 1 ? 0 : 1));
    }
    return chains;
  }

  /// The chains of the remaining segments. Each is closed if no more than two segments meet at any vertex.
  std::vector<std::vector<std::uint32_t>> closed() {
    std::vector<std::vector<std::uint32_t>> chains;
    for (std::uint32_t segment = 0; segment < segments_.size(); ++segment) {
      if (used_[segment]) continue;
      chains.push_back(trace(segment, 0));
    }
    return chains;
  }

 private:
  std::vector<std::uint32_t> trace(std::uint32_t segment, std::size_t start) {
    std::uint32_t vertex = segments_[segment][start];
    std::vector<std::uint32_t> chain{vertex};
    while (true) {
      vertex = segments_[segment][0] == vertex ? segments_[segment][1] : segments_[segment][0];
      chain.push_back(vertex);
      use(segment);
      if (left_[vertex] == 0) return chain;
      segment = first_unused(vertex);
    }
  }

  void use(std::uint32_t segment) {
    used_[segment] = true;
    loose_.erase(segment);
    for (const std::uint32_t vertex : segments_[segment]) {
      --left_[vertex];
      mark_if_loose(vertex);
    }
  }

  /// A segment whose vertex has no other unused segment starts an open chain.
  void mark_if_loose(std::uint32_t vertex) {
    if (left_[vertex] == 1) loose_.insert(first_unused(vertex));
  }

  std::uint32_t first_unused(std::uint32_t vertex) {
    while (used_[at_[vertex][first_[vertex]]]) ++first_[vertex];
    return at_[vertex][first_[vertex]];
  }

  const std::vector<Segment>& segments_;
  std::vector<bool> used_;
  std::vector<std::vector<std::uint32_t>> at_;  ///< segments of each vertex
  /// Per vertex, an index into its segments in at_; all segments before it are used.
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> left_;  ///< number of unused segments of each vertex
  std::set<std::uint32_t> loose_;
};

std::int64_t steps(double coordinate) {
  if (!(std::abs(coordinate) <= largest_coordinate)) {
    throw InputError("a coordinate of the drawing exceeds 1e12; scale the drawing down");
  }
  return std::llround(coordinate / step);
}

}  // namespace

std::uint32_t Segments::vertex(const glm::dvec2& point) {
  const std::int64_t x = steps(point.x);
  const std::int64_t y = steps(point.y);
  // Nearest cells first: the cell itself, then those that share an edge, then those that share a corner.
  constexpr std::array<std::array<int, 2>, 9> around{
      {{0, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, 0}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}}};
  for (const auto& [right, up] : around) {
    const auto found = grid_.find({x + right, y + up});
    if (found != grid_.end()) return found->second;
  }
  const auto index = static_cast<std::uint32_t>(vertices_.size());
  grid_.emplace(std::pair(x, y), index);
  vertices_.emplace_back(static_cast<double>(x) * step, static_cast<double>(y) * step);
  return index;
}

void Segments::add(const glm::dvec2& from, const glm::dvec2& to) {
  const std::uint32_t start = vertex(from);
  const std::uint32_t end = vertex(to);
  if (start == end) return;
  if (segments_.size() == max_segments) {
    throw InputError("the drawing has more than " + std::to_string(max_segments) + " segments; simplify it");
  }
  segments_.push_back({start, end});
}

glm::dvec2 Segments::snap(const glm::dvec2& point) { return vertices_[vertex(point)]; }

/// Whether OpenSCAD would reverse a chain, as it does with closed chains in a drawing without open chains. The sides at
/// the first corner with minimum x decide; OpenSCAD measures their angles from the y axis.
bool Segments::is_turned(const std::vector<std::uint32_t>& chain) const {
  const auto at = [&](std::size_t i) { return vertices_[chain[i]]; };
  const std::size_t last = chain.size() - 1;
  std::size_t least = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (at(i).x < at(least).x) least = i;
  }
  const glm::dvec2 before = at(least == 0 ? last - 1 : least - 1) - at(least);
  const glm::dvec2 after = at(least == last ? 1 : least + 1) - at(least);
  return std::atan2(before.x, before.y) < std::atan2(after.x, after.y);
}

std::vector<Outline> Segments::outlines() const {
  Tracer tracer(segments_, vertices_.size());
  std::vector<std::vector<std::uint32_t>> chains = tracer.open();
  const bool turns = chains.empty();
  for (std::vector<std::uint32_t>& chain : tracer.closed()) {
    // Both ends are the same vertex, unless several segments meet there, so one of the two is dropped.
    chain.erase(turns && is_turned(chain) ? chain.end() - 1 : chain.begin());
    chains.push_back(std::move(chain));
  }
  std::vector<Outline> result;
  for (const std::vector<std::uint32_t>& chain : chains) {
    Outline& outline = result.emplace_back();
    for (const std::uint32_t vertex : chain) outline.push_back(vertices_[vertex]);
  }
  return result;
}

}  // namespace csgsim::flat::dxf
