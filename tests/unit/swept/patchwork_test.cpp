#include <glm/vec2.hpp>

#include "host/swept/element.h"
#include "host/swept/filter.h"
#include "host/swept/mesh.h"
#include "host/swept/output.h"
#include "host/swept/quadtree.h"
#include "host/swept/surface.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace swept;

namespace {

/// Nodes of a DF-expression (as in filter_test.cpp) over a square with side 4; the height of a point is x^2 + y^2.
class DrawnStream : public swept::Stream {
 public:
  DrawnStream(std::string_view expression, const glm::dvec2& low, swept::SubdivisionCounts& counts)
      : expression_(expression), low_(low), counts_(counts), waiting_{{}} {}

  std::optional<swept::Node> next() override {
    if (waiting_.empty()) return std::nullopt;
    const Square square = waiting_.back();
    waiting_.pop_back();
    ++counts_.nodes;
    swept::Node node{expression_.at(at_++) == 'L', {square, {}}};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const double x = low_.x + 4.0 * (square.x + (corner % 2) * square.size) / swept::whole_side;
      const double y = low_.y + 4.0 * (square.y + (corner / 2) * square.size) / swept::whole_side;
      node.element.corners[corner] = {x, y, x * x + y * y};
    }
    const std::uint32_t half = square.size / 2;
    for (std::uint32_t part = 4; !node.is_leaf && part-- > 0;)
      waiting_.push_back({square.x + (part % 2) * half, square.y + (part / 2) * half, half});
    return node;
  }

 private:
  std::string_view expression_;
  glm::dvec2 low_;
  swept::SubdivisionCounts& counts_;
  std::size_t at_ = 0;
  std::vector<Square> waiting_;
};

class DrawnSurface : public swept::Surface {
 public:
  DrawnSurface(std::size_t columns, std::vector<std::string> patches)
      : columns_(columns), patches_(std::move(patches)) {}

  [[nodiscard]] std::size_t columns() const override { return columns_; }
  [[nodiscard]] std::size_t rows() const override { return patches_.size() / columns_; }
  std::unique_ptr<swept::Stream> subdivide(std::size_t column, std::size_t row, const swept::Accuracy&,
                                           swept::SubdivisionCounts& counts) override {
    return std::make_unique<DrawnStream>(patches_[row * columns_ + column], 4.0 * glm::dvec2(column, row), counts);
  }

 private:
  std::size_t columns_;
  std::vector<std::string> patches_;
};

Patchwork patchwork(std::size_t columns, const std::vector<std::string>& patches, Repair repair) {
  DrawnSurface surface(columns, patches);
  return swept::make_patchwork(surface, {}, repair);
}

using Ring = std::vector<std::array<double, 3>>;

/// Positions of an element's vertices, starting at the least.
std::set<Ring> vertex_rings(const Patchwork& made) {
  std::set<Ring> rings;
  for (const std::vector<std::uint32_t>& element : made.elements) {
    Ring ring;
    for (const std::uint32_t vertex : element) {
      const glm::dvec3& point = made.points.at(vertex);
      ring.push_back({point.x, point.y, point.z});
    }
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    rings.insert(std::move(ring));
  }
  return rings;
}

constexpr std::array both_repairs{Repair::filter, Repair::quadtree};

/// Counts of a repair of one patch without a wire frame.
RepairCounts repaired(const std::string& expression, Repair repair) {
  swept::SubdivisionCounts counts;
  DrawnStream stream(expression, {0, 0}, counts);
  swept_test::Record record;
  RepairCounts repairs;
  (repair == Repair::filter ? swept::filter : swept::repair_by_quadtree)(stream, nullptr, record, repairs);
  CHECK(record.fault == "");
  CHECK(record.points.size() == repairs.vertices);
  CHECK(record.elements.size() == repairs.elements);
  return repairs;
}

}  // namespace

TEST_CASE("the filter visits two edges per element and one more per merge") {
  struct Row {
    const char* expression;
    std::uint64_t elements;
    std::uint64_t splits;
    std::uint64_t merges;
    std::uint64_t most_edges;
  };
  // The border starts with two edges; each split adds an edge and each merge removes one. In the third row the four
  // quarters of quarter 1 split both edges twice; quarter 2 merges the edges beside it and quarter 3 those below it. In
  // the fourth row 41 splits the sides of quarters 2 and 3 as well as both edges of the patch.
  for (const Row& row : {Row{"L", 1, 0, 0, 2}, Row{"(LLLL", 4, 2, 0, 4}, Row{"((LLLLLLL", 7, 4, 2, 6},
                         Row{"(LLL(LLLL", 7, 4, 0, 6}, Row{"((LLLL(LLLLLL", 10, 5, 2, 7}}) {
    CAPTURE(row.expression);
    const RepairCounts counts = repaired(row.expression, Repair::filter);
    CHECK(counts.elements == row.elements);
    CHECK(counts.splits == row.splits);
    CHECK(counts.merges == row.merges);
    CHECK(counts.edges_visited == 2 * row.elements + row.merges);
    CHECK(counts.most_edges == row.most_edges);
  }
}

TEST_CASE("the quadtree's neighbour visits and held nodes equal the hand counts") {
  // A lone leaf visits itself in each search: at each corner for other leaves across two sides (8), and at each side
  // for its neighbour (4), twice. Among quarters a search within the square visits one node, and a search beyond it
  // visits two, the quarter and the whole. At corners, the south-west quarter takes 4 visits, 1 + 3 + 2, the same
  // again, and in the middle of the square 1, 1 + 1 + 1 + 1 + 2 around the three others, and 1; the south-east quarter
  // emits two more corners with 4 and 2 + 1 + 3 visits, the north-west quarter two with the same, and the north-east
  // quarter the last one with 4. At sides a quarter takes 1 + 1 + 2 + 2 visits, twice.
  struct Row {
    const char* expression;
    std::uint64_t nodes;
    std::uint64_t leaves;
    std::uint64_t vertices;
    std::uint64_t visited;
  };
  for (const Row& row :
       {Row{"L", 1, 1, 4, 8 + 4 + 4}, Row{"(LLLL", 5, 4, 9, (4 + 6 + 6 + 8) + (4 + 6) + (4 + 6) + 4 + 2 * 4 * 6}}) {
    CAPTURE(row.expression);
    const RepairCounts counts = repaired(row.expression, Repair::quadtree);
    CHECK(counts.edges_visited == row.visited);
    CHECK(counts.elements == row.leaves);
    CHECK(counts.most_elements == row.leaves);
    CHECK(counts.vertices == row.vertices);
    CHECK(counts.most_vertices == row.vertices);
    CHECK(counts.most_edges == row.nodes);
    CHECK(counts.splits == 0);
    CHECK(counts.merges == 0);
  }
}

TEST_CASE("a larger patch gets the vertex of a smaller neighbour on its common side") {
  // A whole patch next to quarters: the common edge is one segment between its ends; the vertex in its middle is on the
  // line.
  struct Row {
    std::size_t columns;
    bool is_small_first;
    glm::dvec2 from;  ///< the common edge
    glm::dvec2 to;
  };
  for (const Row& row : {Row{2, true, {4, 0}, {4, 4}}, Row{2, false, {4, 0}, {4, 4}}, Row{1, true, {0, 4}, {4, 4}},
                         Row{1, false, {0, 4}, {4, 4}}}) {
    for (const Repair repair : both_repairs) {
      CAPTURE(row.columns);
      CAPTURE(row.is_small_first);
      CAPTURE(static_cast<int>(repair));
      const Patchwork made =
          patchwork(row.columns, {row.is_small_first ? "(LLLL" : "L", row.is_small_first ? "L" : "(LLLL"}, repair);
      // Six corners of the patches, the middles of the small one's four edges, and its middle.
      CHECK(made.points.size() == 11);
      CHECK(made.wire_vertices == 10);
      CHECK(made.repair.vertices == 11);
      CHECK(made.repair.snaps == 1);
      CHECK(made.elements.size() == 5);
      CHECK(made.repair.elements == 5);
      CHECK(made.wiring.nodes == 6);
      CHECK(made.subdivision.nodes == 6);
      const auto large = std::ranges::find(made.elements, 5U, [](const auto& element) { return element.size(); });
      REQUIRE(large != made.elements.end());
      const glm::dvec2 middle = (row.from + row.to) / 2.0;
      const double height = (glm::dot(row.from, row.from) + glm::dot(row.to, row.to)) / 2;
      int on_edge = 0;
      for (std::size_t i = 0; i < 5; ++i) {
        const glm::dvec3& here = made.points[(*large)[i]];
        const glm::dvec3& next = made.points[(*large)[(i + 1) % 5]];
        const glm::dvec3& after = made.points[(*large)[(i + 2) % 5]];
        CHECK((next.x - here.x) * (after.y - next.y) - (next.y - here.y) * (after.x - next.x) >= 0);
        if (here == glm::dvec3(middle, height)) ++on_edge;
      }
      CHECK(on_edge == 1);
      if (repair == Repair::filter) {
        // If the large patch comes first, the first quarter splits the common segment.
        CHECK(made.repair.splits == (row.is_small_first ? 0 : 1));
        CHECK(made.repair.merges == 0);
        CHECK(made.repair.edges_visited == 2 * 5);
        // The maxima occur in the small patch: two edges in the west and two in the south; at its end the quarters 2, 3
        // and 4, without the vertex that belongs only to quarter 1.
        CHECK(made.repair.most_edges == 4);
        CHECK(made.repair.most_elements == 3);
        CHECK(made.repair.most_vertices == 8);
      } else {
        CHECK(made.repair.most_edges == 5);
        CHECK(made.repair.most_elements == 4);
        CHECK(made.repair.most_vertices == 9);
      }
    }
  }
}

TEST_CASE("both repairs yield the same elements for neighbouring subdivided patches") {
  // Expressions divided in different corners, next to each other in both directions.
  const std::vector<std::string> kinds{"L",         "(LLLL",     "((LLLLLLL",    "(LL(LLLLL",
                                       "(L(LLLLLL", "(LLL(LLLL", "((LLLL(LLLLLL"};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      for (const std::size_t columns : {std::size_t{1}, std::size_t{2}}) {
        CAPTURE(kinds[i]);
        CAPTURE(kinds[k]);
        CAPTURE(columns);
        const Patchwork filtered = patchwork(columns, {kinds[i], kinds[k], kinds[k], kinds[i]}, Repair::filter);
        const Patchwork kept = patchwork(columns, {kinds[i], kinds[k], kinds[k], kinds[i]}, Repair::quadtree);
        CHECK(vertex_rings(filtered) == vertex_rings(kept));
        CHECK(filtered.wire_vertices == kept.wire_vertices);
        CHECK(filtered.repair.vertices == filtered.points.size());
        CHECK(kept.repair.vertices == kept.points.size());
        CHECK(filtered.repair.snaps == kept.repair.snaps);
        CHECK(filtered.repair.edges_visited == 2 * filtered.repair.elements + filtered.repair.merges);
        // Every element is closed, and edges run once in each direction except the outer ones.
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const auto& element : filtered.elements) {
          for (std::size_t at = 0; at < element.size(); ++at)
            CHECK(edges.emplace(element[at], element[(at + 1) % element.size()]).second);
        }
        const double wide = 4.0 * static_cast<double>(columns);
        const double high = 16 / wide * 4.0;
        for (const auto& [from, to] : edges) {
          if (edges.contains({to, from})) continue;
          const glm::dvec3& a = filtered.points[from];
          const glm::dvec3& b = filtered.points[to];
          CHECK(((a.x == b.x && (a.x == 0 || a.x == wide)) || (a.y == b.y && (a.y == 0 || a.y == high))));
        }
      }
    }
  }
}

TEST_CASE("vertices on nested lines and between patches move onto the larger lines") {
  // The west patch has quarters of quarters at the common edge, the east patch has quarters. The segments of the edge
  // are its halves, (4, 0, 16) to (4, 2, 20) to (4, 4, 32), with the vertices at 1 and 3 half-way.
  for (const Repair repair : both_repairs) {
    const Patchwork made = patchwork(2, {"(L(LLLLL(LLLL", "(LLLL"}, repair);
    const auto has = [&](const glm::dvec3& point) {
      return std::ranges::find(made.points, point) != made.points.end();
    };
    CHECK(has({4, 1, 18}));
    CHECK(has({4, 3, 26}));
    CHECK(has({4, 2, 20}));
    // Vertices within the west patch are on the surface where no larger element is above or below, and on the lines of
    // the quarters in its west next to these.
    CHECK(has({3, 1, 10}));
    CHECK(has({2, 1, 6}));
    CHECK(has({2, 3, 14}));
    CHECK(made.repair.snaps == 4);
  }
}

TEST_CASE("one patch has no wire frame and nine patches share one of 16 vertices") {
  for (const Repair repair : both_repairs) {
    const Patchwork alone = patchwork(1, {"(LLLL"}, repair);
    CHECK(alone.wire_vertices == 0);
    CHECK(alone.wiring.nodes == 0);
    CHECK(alone.subdivision.nodes == 5);
    CHECK(alone.repair.vertices == 9);
    CHECK(alone.points.size() == 9);
    CHECK(alone.elements.size() == 4);
    const Patchwork nine = patchwork(3, std::vector<std::string>(9, "L"), repair);
    CHECK(nine.wire_vertices == 16);
    CHECK(nine.repair.vertices == 16);
    CHECK(nine.repair.snaps == 0);
    CHECK(nine.wiring.nodes == 9);
  }
}

TEST_CASE("a block's patches share vertices around it and along a closed trajectory") {
  const swept::Curve square{1, true, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
  const swept::SweptSolid block =
      swept::make_swept_solid({square, {1, false, {{0, 0, 0}, {0, 0, 3}, {0, 0, 7}}}}, {0.1});
  CHECK(block.patchwork.wire_vertices == 12);
  CHECK(block.patchwork.elements.size() == 8);
  CHECK(block.mesh.points.size() == 12);
  CHECK(block.mesh.faces.size() == 8 + 2);
  const swept::SweptSolid frame =
      swept::make_swept_solid({square, {1, true, {{0, 0, 0}, {9, 0, 0}, {9, 0, 9}, {0, 0, 9}}}}, {0.1});
  CHECK(frame.patchwork.wire_vertices == 16);
  CHECK(frame.mesh.points.size() == 16);
  CHECK(frame.mesh.faces.size() == 16);
  CHECK(swept_test::open_edge(frame.mesh.faces).empty());
}

TEST_CASE("a bent element of four corners is split along its shorter diagonal") {
  // The sides of a square block twisted by an angle a: for positive a, the diagonal from the south-east corner is
  // shorter, the root of 4 - 4 sin a + h^2; for negative a, the other.
  for (const double degrees : {20.0, -20.0}) {
    CAPTURE(degrees);
    swept::Sweep sweep{{1, true, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, {1, false, {{0, 0, 0}, {0, 0, 3}}}};
    sweep.rotation = {1, false, {{0, 0, 0}, {degrees, 0, 0}}};
    const swept::SweptSolid solid = swept::make_swept_solid(sweep, {10, swept::Flatness::plane});
    CHECK(swept_test::open_edge(solid.mesh.faces).empty());
    REQUIRE(solid.mesh.faces.size() == 2 + 2 * 4);
    CHECK(solid.mesh.points.size() == 8);
    double longest = 0;
    for (const auto& face : solid.mesh.faces) {
      if (face.size() != 3) continue;
      for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(solid.mesh.points[face[i]], solid.mesh.points[face[(i + 1) % 3]]));
    }
    CHECK(longest == doctest::Approx(std::sqrt(4 - 4 * std::sin(std::numbers::pi / 9) + 9)));
    // A prismatoid: its middle section is an octagon between squares, with four corners from the sides' middles and
    // four from the diagonals'. Simpson's rule is exact for it: h / 6 times (4 + 4 + 4 times its area), the area from
    // its corners by the shoelace formula.
    std::vector<glm::dvec2> section;
    const double turn = degrees * std::numbers::pi / 180;
    for (int k = 0; k < 4; ++k) {
      const auto corner = [&](double angle) { return std::sqrt(2.0) * glm::dvec2(std::cos(angle), std::sin(angle)); };
      const double here = (-3 + 2 * k) * std::numbers::pi / 4;
      const double next = here + std::numbers::pi / 2;
      section.push_back((corner(here) + corner(here + turn)) / 2.0);
      section.push_back(degrees > 0 ? (corner(next) + corner(here + turn)) / 2.0
                                    : (corner(here) + corner(next + turn)) / 2.0);
    }
    double area = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const glm::dvec2& a = section[i];
      const glm::dvec2& b = section[(i + 1) % 8];
      area += (a.x * b.y - b.x * a.y) / 2;
    }
    CHECK(swept_test::volume(solid.mesh) == doctest::Approx(3.0 / 6 * (4 + 4 + 4 * area)));
  }
}
