#include "host/swept/filter.h"

#include <rapidcheck.h>

#include <tuple>

#include "host/swept/quadtree.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace csgsim::swept_test;
using namespace swept;

namespace {

/// Nodes of a DF-expression, a quadtree in text: `(` is a divided square and `L` a leaf; its quarters are 1 south-west,
/// 2 south-east, 3 north-west and 4 north-east. The function gives the height of a corner.
class WrittenStream : public swept::Stream {
 public:
  using Height = double (*)(double x, double y);

  WrittenStream(std::string_view expression, Height height) : expression_(expression), height_(height), waiting_{{}} {}

  std::optional<swept::Node> next() override {
    if (waiting_.empty()) return std::nullopt;
    const Square square = waiting_.back();
    waiting_.pop_back();
    swept::Node node{expression_.at(at_++) == 'L', {square, {}}};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const double x = place(square.x + (corner % 2) * square.size);
      const double y = place(square.y + (corner / 2) * square.size);
      node.element.corners[corner] = {x, y, height_(x, y)};
    }
    const std::uint32_t half = square.size / 2;
    for (std::uint32_t part = 4; !node.is_leaf && part-- > 0;)
      waiting_.push_back({square.x + (part % 2) * half, square.y + (part / 2) * half, half});
    return node;
  }

 private:
  static double place(std::uint32_t value) { return 4.0 * value / swept::whole_side; }

  std::string_view expression_;
  Height height_;
  std::size_t at_ = 0;
  std::vector<Square> waiting_;
};

double bowl(double x, double y) { return x * x + y * y; }

struct Repaired {
  Record record;
  swept::RepairCounts counts;
};

using Way = void (*)(swept::Stream&, const swept::PatchEdges*, swept::Output&, swept::RepairCounts&);

void repair(swept::Stream& stream, Way way, Repaired& repaired) {
  way(stream, nullptr, repaired.record, repaired.counts);
}

void repair(swept::Surface& surface, const swept::Accuracy& accuracy, Way way, Repaired& repaired) {
  swept::SubdivisionCounts counts;
  repair(*surface.subdivide(0, 0, accuracy, counts), way, repaired);
}

using Place = std::array<std::uint32_t, 2>;

std::array<Place, 4> corner_places(const Square& square) {
  return {Place{square.x, square.y}, Place{square.x + square.size, square.y},
          Place{square.x + square.size, square.y + square.size}, Place{square.x, square.y + square.size}};
}

bool is_inside_side(const Place& place, const Place& one, const Place& other) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t across = 1 - axis;
    if (one[across] == other[across] && place[across] == one[across] &&
        std::min(one[axis], other[axis]) < place[axis] && place[axis] < std::max(one[axis], other[axis]))
      return true;
  }
  return false;
}

double segment_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(glm::cross(p - a, p - b)) / glm::distance(a, b);
}

/// Counts corners of leaves that are on the side of another leaf but off its line, by pairwise comparison.
int count_cracks(const std::vector<Element>& leaves) {
  int count = 0;
  constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
  for (const Element& large : leaves) {
    const std::array<Place, 4> places = corner_places(large.square);
    for (const Element& small : leaves) {
      const std::array<Place, 4> others = corner_places(small.square);
      for (std::size_t corner = 0; corner < 4; ++corner) {
        for (std::size_t side = 0; side < 4; ++side) {
          if (is_inside_side(others[corner], places[side], places[(side + 1) % 4]) &&
              segment_distance(small.corners[around[corner]], large.corners[around[side]],
                               large.corners[around[(side + 1) % 4]]) > 1e-9)
            ++count;
        }
      }
    }
  }
  return count;
}

/// Parameters of a vertex of a random net: its x and y are linear in the parameters, and remain so on lines.
Place place_of(const glm::dvec3& point) {
  const auto place = [](double value) {
    return static_cast<std::uint32_t>(std::lround((value - 10) / 10 * swept::whole_side));
  };
  return {place(point.x), place(point.y)};
}

/// Elements with their corners after a repair, and then the vertices on their sides in order.
std::vector<Element> leaves_of(const Record& record) {
  std::vector<Element> leaves;
  for (const Record::RecordedElement& taken : record.elements) {
    Element& leaf = leaves.emplace_back();
    leaf.square = taken.square;
    for (const std::uint32_t number : taken.corners) {
      const glm::dvec3& point = record.points.at(number);
      constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
      const auto places = corner_places(taken.square);
      for (std::size_t i = 0; i < 4; ++i) {
        if (places[i] == place_of(point)) leaf.corners[around[i]] = point;
      }
    }
  }
  return leaves;
}

/// Recomputes what the filter holds after each element: the elements that touch a missing one, their vertices, and the
/// vertices that may still move.
class Recount {
 public:
  explicit Recount(std::vector<Element> leaves) : leaves_(std::move(leaves)) {
    for (const Element& leaf : leaves_) {
      for (const Place& place : corner_places(leaf.square)) vertices_.insert(place);
    }
    for (std::size_t count = 1; count <= leaves_.size(); ++count) take(count);
  }

  std::size_t most_elements = 0;
  std::size_t most_vertices = 0;
  [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }

 private:
  /// The leaf of a unit square; none outside.
  [[nodiscard]] std::size_t leaf_at(std::int64_t x, std::int64_t y) const {
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const Square& square = leaves_[i].square;
      if (x >= square.x && y >= square.y && x < square.x + square.size && y < square.y + square.size) return i;
    }
    return leaves_.size();
  }

  /// Whether there is a border between the leaves of two unit squares: one is present, the other is missing or outside
  /// the patch.
  [[nodiscard]] bool is_border(std::int64_t x, std::int64_t y, std::int64_t to_x, std::int64_t to_y,
                               std::size_t count) const {
    if (x < 0 || y < 0) return false;
    return leaf_at(x, y) < count && leaf_at(to_x, to_y) >= count;
  }

  [[nodiscard]] bool is_on_border(const Place& place, std::size_t count) const {
    const std::int64_t x = place[0];
    const std::int64_t y = place[1];
    return is_border(x - 1, y - 1, x - 1, y, count) || is_border(x, y - 1, x, y, count) ||
           is_border(x - 1, y - 1, x, y - 1, count) || is_border(x - 1, y, x, y, count);
  }

  [[nodiscard]] bool reaches_border(const Element& leaf, std::size_t count) const {
    const Square& square = leaf.square;
    const auto has_come = [&](std::int64_t x, std::int64_t y) { return leaf_at(x, y) < count; };
    for (const Place& place : vertices_) {
      // The unit square beyond the side, at each vertex of the north and the east side including its ends.
      if (place[1] == square.y + square.size && place[0] >= square.x && place[0] < square.x + square.size &&
          !has_come(place[0], place[1]))
        return true;
      if (place[0] == square.x + square.size && place[1] >= square.y && place[1] < square.y + square.size &&
          !has_come(place[0], place[1]))
        return true;
    }
    return false;
  }

  /// Whether the vertex can still move.
  [[nodiscard]] bool is_open(const Place& place, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto places = corner_places(leaves_[i].square);
      for (std::size_t side = 0; side < 4; ++side) {
        const Place& from = places[side];
        const Place& to = places[(side + 1) % 4];
        if (is_inside_side(place, from, to)) return is_open(from, count) || is_open(to, count);
      }
    }
    return is_on_border(place, count);
  }

  void take(std::size_t count) {
    std::set<Place> come;
    for (std::size_t i = 0; i < count; ++i) {
      for (const Place& place : corner_places(leaves_[i].square)) come.insert(place);
    }
    std::set<Place> held;
    std::size_t elements = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!reaches_border(leaves_[i], count)) continue;
      ++elements;
      const auto places = corner_places(leaves_[i].square);
      for (const Place& place : come) {
        for (std::size_t side = 0; side < 4; ++side) {
          if (place == places[side] || is_inside_side(place, places[side], places[(side + 1) % 4])) held.insert(place);
        }
      }
    }
    for (const Place& place : come) {
      if (is_open(place, count)) held.insert(place);
    }
    most_elements = std::max(most_elements, elements);
    most_vertices = std::max(most_vertices, held.size());
  }

  std::vector<Element> leaves_;
  std::set<Place> vertices_;
};

/// Faces by the parameters and positions of their vertices, independent of vertex numbers.
std::set<std::vector<std::array<double, 3>>> faces_of(const Record& record) {
  std::set<std::vector<std::array<double, 3>>> faces;
  for (const Record::RecordedElement& taken : record.elements) {
    std::vector<std::array<double, 3>> face;
    for (const std::uint32_t number : taken.corners) {
      const glm::dvec3& point = record.points.at(number);
      face.push_back({point.x, point.y, point.z});
    }
    faces.insert(std::move(face));
  }
  return faces;
}

}  // namespace

TEST_CASE("the vertex in thesis figure 3.4 moves onto the line of the larger element") {
  // Only quarter 4 is divided: 41 and 42 border on quarter 2, 41 and 43 on quarter 3.
  WrittenStream stream("(LLL(LLLL", bowl);
  Repaired repaired;
  repair(stream, swept::filter, repaired);
  CHECK(repaired.record.elements.size() == 7);
  std::set<std::array<double, 3>> points;
  for (const auto& [number, point] : repaired.record.points) points.insert({point.x, point.y, point.z});
  CHECK(points.size() == 14);
  CHECK(points.contains({3, 2, 14}));  // half-way between (2, 2, 8) and (4, 2, 20), not at 13
  CHECK(points.contains({2, 3, 14}));
  CHECK(points.contains({3, 3, 18}));  // between four elements of one size, so on the surface
  CHECK(points.contains({4, 3, 25}));  // at the patch's edge
  CHECK(repaired.counts.snaps == 2);
  CHECK(repaired.counts.splits == 4);  // two edges of the patch, and the sides of 2 and 3
  CHECK(repaired.counts.merges == 0);
  CHECK(repaired.counts.elements == 7);
  CHECK(repaired.counts.vertices == 14);
}

TEST_CASE("a larger element after smaller ones takes their vertices onto its line") {
  WrittenStream stream("((LLLLLLL", bowl);
  Repaired repaired;
  repair(stream, swept::filter, repaired);
  std::set<std::array<double, 3>> points;
  for (const auto& [number, point] : repaired.record.points) points.insert({point.x, point.y, point.z});
  CHECK(points.contains({2, 1, 6}));  // between (2, 0, 4) and (2, 2, 8)
  CHECK(points.contains({1, 2, 6}));
  CHECK(repaired.counts.merges == 2);
  CHECK(repaired.counts.snaps == 2);
}

TEST_CASE("the filter emits an element once no missing element touches it") {
  WrittenStream stream("(LLL(LLLL", bowl);
  Repaired repaired;
  repair(stream, swept::filter, repaired);
  const auto order = [&](std::size_t i) {
    const Square square = repaired.record.elements[i].square;
    return std::array{square.x * 4 / swept::whole_side, square.y * 4 / swept::whole_side};
  };
  // Quarter 1 is complete after 2 and 3, and 41 after 42 and 43; all others are at the patch's edge.
  CHECK(order(0) == std::array{0U, 0U});
  CHECK(order(1) == std::array{2U, 2U});
  CHECK(repaired.counts.most_elements == 5);
}

TEST_CASE("the filter removes all cracks from random nets") {
  int before = 0;
  CHECK(rc::check([&] {
    const auto surface = swept::make_surface(random_net(4, 4, 40));
    const swept::Accuracy accuracy{0.2};
    before += count_cracks(swept_test::leaves_of(*surface, 0, 0, accuracy));
    Repaired repaired;
    repair(*surface, accuracy, swept::filter, repaired);
    RC_ASSERT(repaired.record.fault.empty());
    RC_ASSERT(count_cracks(leaves_of(repaired.record)) == 0);
  }));
  CHECK((!testing::draws_usual_cases() || before > 500));
}

TEST_CASE("unmatched edges of a repaired mesh are only on the patch's border") {
  CHECK(rc::check([] {
    const auto surface = swept::make_surface(random_net(4, 4, 40));
    Repaired repaired;
    repair(*surface, {0.5}, swept::filter, repaired);
    // A face outside the patch's edge closes it.
    std::vector<std::vector<std::uint32_t>> faces;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
    for (const Record::RecordedElement& taken : repaired.record.elements) {
      faces.push_back(taken.corners);
      for (std::size_t i = 0; i < taken.corners.size(); ++i)
        edges[{taken.corners[i], taken.corners[(i + 1) % taken.corners.size()]}] = true;
    }
    for (const auto& [edge, unused] : edges) {
      if (edges.contains({edge.second, edge.first})) continue;
      const Place from = place_of(repaired.record.points.at(edge.first));
      const Place to = place_of(repaired.record.points.at(edge.second));
      const bool is_outer = (from[0] == to[0] && (from[0] == 0 || from[0] == swept::whole_side)) ||
                            (from[1] == to[1] && (from[1] == 0 || from[1] == swept::whole_side));
      RC_ASSERT(is_outer);
    }
    RC_ASSERT(repaired.record.points.size() == repaired.counts.vertices);
  }));
}

TEST_CASE("the filter's peak counts of held elements and vertices equal a recount") {
  std::size_t cases = 0;
  CHECK(rc::check([&] {
    const auto surface = swept::make_surface(random_net(4, 4, 30));
    const swept::Accuracy accuracy{1.5};
    std::vector<Element> leaves = swept_test::leaves_of(*surface, 0, 0, accuracy);
    if (leaves.size() > 200) return;
    ++cases;
    const Recount recount(std::move(leaves));
    Repaired repaired;
    repair(*surface, accuracy, swept::filter, repaired);
    RC_ASSERT(repaired.counts.most_elements == recount.most_elements);
    RC_ASSERT(repaired.counts.most_vertices == recount.most_vertices);
    RC_ASSERT(repaired.counts.vertices == recount.vertices());
  }));
  CHECK((!testing::draws_usual_cases() || cases > 30));
}

TEST_CASE("the quadtree repair makes the same mesh as the filter but holds all of it") {
  CHECK(rc::check([] {
    const auto surface = swept::make_surface(random_net(4, 4, 40));
    const swept::Accuracy accuracy{0.5};
    Repaired filtered;
    repair(*surface, accuracy, swept::filter, filtered);
    Repaired kept;
    repair(*surface, accuracy, swept::repair_by_quadtree, kept);
    RC_ASSERT(kept.record.fault.empty());
    RC_ASSERT(faces_of(filtered.record) == faces_of(kept.record));
    RC_ASSERT(kept.counts.vertices == filtered.counts.vertices);
    RC_ASSERT(kept.counts.snaps == filtered.counts.snaps);
    RC_ASSERT(kept.counts.most_elements == kept.counts.elements);
    RC_ASSERT(kept.counts.most_vertices == kept.counts.vertices);
  }));
}

TEST_CASE("patches share all vertices on their common sides after either repair") {
  CHECK(rc::check([] {
    const auto surface = swept::make_surface(random_net(5, 6, 40));
    const auto way = *rc::gen::element(swept::Repair::filter, swept::Repair::quadtree);
    const swept::Patchwork made = swept::make_patchwork(*surface, {1.0}, way);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& element : made.elements) {
      for (std::size_t i = 0; i < element.size(); ++i)
        RC_ASSERT(edges.emplace(element[i], element[(i + 1) % element.size()]).second);
    }
    // The patches' parameters are x and y, from 10 to 40 and to 30.
    const auto is_at = [](double value, double edge) { return std::abs(value - edge) < 1e-6; };
    std::size_t outer = 0;
    for (const auto& [from, to] : edges) {
      if (edges.contains({to, from})) continue;
      ++outer;
      const glm::dvec3& a = made.points[from];
      const glm::dvec3& b = made.points[to];
      RC_ASSERT((is_at(a.x, b.x) && (is_at(a.x, 10) || is_at(a.x, 40))) ||
                (is_at(a.y, b.y) && (is_at(a.y, 10) || is_at(a.y, 30))));
    }
    RC_ASSERT(outer >= 10U);
    RC_ASSERT(made.repair.vertices == made.points.size());
    // Three vertices in a row on a side are on a line.
    for (const auto& element : made.elements) {
      for (std::size_t i = 0; i < element.size(); ++i) {
        const glm::dvec3& a = made.points[element[i]];
        const glm::dvec3& b = made.points[element[(i + 1) % element.size()]];
        const glm::dvec3& c = made.points[element[(i + 2) % element.size()]];
        const bool is_side = (is_at(a.x, b.x) && is_at(b.x, c.x)) || (is_at(a.y, b.y) && is_at(b.y, c.y));
        RC_ASSERT(!is_side || segment_distance(b, a, c) < 1e-9);
      }
    }
    // Euler characteristic: faces, edges and vertices of a disc.
    const auto sides = static_cast<std::int64_t>((edges.size() + outer) / 2);
    RC_ASSERT(static_cast<std::int64_t>(made.points.size() + made.elements.size()) - sides == 1);
  }));
}
