// Checks where k-d trees and bounding volume hierarchies are split: against an exhaustive search by the surface area
// heuristic, and against middle splits calculated by hand.

#include <glm/vec3.hpp>

#include "sim/software/space/directory.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::SpaceBox;
using software::SpacePart;
using testing::Random;

namespace {

using List = std::vector<std::uint32_t>;
using Polygons = std::vector<std::vector<glm::dvec3>>;

/// Returns facets of primitives from each primitive's polygons.
software::Facets primitives_of(const std::vector<Polygons>& primitives) {
  software::Facets facets;
  for (std::uint32_t primitive = 0; primitive < primitives.size(); ++primitive) {
    facets.of_primitives.push_back(facets.facets.size());
    for (const std::vector<glm::dvec3>& corners : primitives[primitive]) {
      const std::size_t begin = facets.corners.size();
      facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
      facets.facets.push_back({primitive, {}, begin, facets.corners.size()});
    }
  }
  facets.of_primitives.push_back(facets.facets.size());
  return facets;
}

/// A triangle that is one unit long along each axis.
std::vector<glm::dvec3> triangle_at(const glm::dvec3& low) {
  return {low, low + glm::dvec3{1, 1, 0}, low + glm::dvec3{0, 1, 1}};
}

/// Triangles of all sizes, some in clusters.
software::Facets any_triangles(Random& random) {
  std::vector<Polygons> primitives;
  const auto somewhere = [&](double size) {
    return glm::dvec3{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5} * size;
  };
  glm::dvec3 crowd{0};
  for (std::uint64_t i = 10 + random.below(60); i > 0; --i) {
    if (random.below(8) == 0) crowd = somewhere(20);
    const double size = random.below(5) == 0 ? 12 : 1.5;
    const glm::dvec3 place = crowd + somewhere(4);
    primitives.push_back({{place, place + somewhere(size), place + somewhere(size)}});
  }
  return primitives_of(primitives);
}

double half_surface(const facet::Box& box) {
  const glm::dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

facet::Box box_around(const software::FacetShapes& shapes, const List& facets) {
  facet::Box box = shapes.box_of(facets.front());
  for (const std::uint32_t facet : facets) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], shapes.box_of(facet).low[axis]);
      box.high[axis] = std::max(box.high[axis], shapes.box_of(facet).high[axis]);
    }
  }
  return box;
}

List facets_below(const std::vector<SpaceBox>& boxes, const SpaceBox& box) {
  List facets(box.facets.begin(), box.facets.end());
  if (box.low != 0) {
    for (const SpaceBox* const half : {&boxes[box.low], &boxes[box.low + 1]}) {
      const List own = facets_below(boxes, *half);
      facets.insert(facets.end(), own.begin(), own.end());
    }
  }
  std::ranges::sort(facets);
  return facets;
}

/// The cheapest division of facets by 16 bins per axis, and the cost of a given division if it is one of these.
struct Divisions {
  double least = std::numeric_limits<double>::infinity();
  std::optional<double> of_given;
};

Divisions divisions_of(const software::FacetShapes& shapes, const List& facets, const List& given) {
  Divisions divisions;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> middles;
    for (const std::uint32_t facet : facets) middles.push_back(shapes.box_of(facet).centre()[axis]);
    const double low = std::ranges::min(middles);
    const double high = std::ranges::max(middles);
    if (low == high) continue;
    for (int bin = 1; bin < 16; ++bin) {
      List below;
      List above;
      for (std::size_t i = 0; i < facets.size(); ++i) {
        const double at = std::min(15.0, std::floor((middles[i] - low) / (high - low) * 16));
        (at < bin ? below : above).push_back(facets[i]);
      }
      const double cost = half_surface(box_around(shapes, below)) * static_cast<double>(below.size()) +
                          half_surface(box_around(shapes, above)) * static_cast<double>(above.size());
      divisions.least = std::min(divisions.least, cost);
      if (below == given) divisions.of_given = cost;
    }
  }
  return divisions;
}

/// Returns the number of divided nodes.
std::size_t check_heuristic_boxes(const software::FacetShapes& shapes, std::uint32_t bucket_size) {
  const auto directory = software::directory_of("bvh").make(shapes, {bucket_size});
  const std::vector<SpaceBox> boxes = directory->boxes();
  std::size_t divided = 0;
  CHECK(facets_below(boxes, boxes[0]) == List(shapes.placed().begin(), shapes.placed().end()));
  for (const SpaceBox& box : boxes) {
    const List facets = facets_below(boxes, box);
    REQUIRE(!facets.empty());
    CHECK(box.box == box_around(shapes, facets));
    const bool is_divided = box.low != 0;
    CHECK(is_divided == (facets.size() > bucket_size));
    if (!is_divided) continue;
    ++divided;
    const Divisions divisions = divisions_of(shapes, facets, facets_below(boxes, boxes[box.low]));
    REQUIRE(divisions.of_given.has_value());
    CHECK(*divisions.of_given <= divisions.least * (1 + 1e-12));
  }
  CHECK(directory->built().splits == divided);
  CHECK(directory->built().overflows == 0);
  return divided;
}

/// A cell of a k-d tree and the costs of walls across it; the end of a facet's box is rounded to one of 32 places to
/// decide its side of a wall.
class CellWalls {
 public:
  CellWalls(const software::FacetShapes& shapes, const facet::Box& box, const List& facets)
      : shapes_(shapes), box_(box), facets_(facets) {}

  [[nodiscard]] double wall(int axis, int number) const {
    return box_.low[axis] + (box_.high[axis] - box_.low[axis]) / 32 * number;
  }

  [[nodiscard]] double cost(int axis, int number) const {
    const auto place = [&](double at) {
      return std::clamp(std::floor((at - box_.low[axis]) / ((box_.high[axis] - box_.low[axis]) / 32)), 0.0, 31.0);
    };
    double below = 0;
    double above = 0;
    for (const std::uint32_t facet : facets_) {
      below += place(shapes_.box_of(facet).low[axis]) < number ? 1 : 0;
      above += place(shapes_.box_of(facet).high[axis]) >= number ? 1 : 0;
    }
    facet::Box low = box_;
    facet::Box high = box_;
    low.high[axis] = high.low[axis] = wall(axis, number);
    return 1 + (half_surface(low) * below + half_surface(high) * above) / half_surface(box_);
  }

  [[nodiscard]] double least() const {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      for (int number = 1; number < 32; ++number) least = std::min(least, cost(axis, number));
    }
    return least;
  }

 private:
  const software::FacetShapes& shapes_;
  const facet::Box& box_;
  const List& facets_;
};

struct KdTally {
  std::size_t divided = 0;
  std::size_t not_cheaper = 0;  ///< cells that no wall makes cheaper
  std::size_t deepest = 0;      ///< cells at the last level with too many facets
};

void check_kd_tree(const software::FacetShapes& shapes, std::uint32_t bucket_size, const std::vector<SpacePart>& parts,
                   std::uint32_t number, const List& facets, unsigned levels, KdTally& tally) {
  const SpacePart& part = parts[number];
  const auto size = static_cast<double>(facets.size());
  if (part.is_cell()) {
    CHECK(List(part.facets.begin(), part.facets.end()) == facets);
    if (facets.size() <= bucket_size) return;
    tally.deepest += levels == 0 ? 1U : 0U;
    if (levels == 0) return;
    ++tally.not_cheaper;
    CHECK(CellWalls(shapes, part.box, facets).least() >= size * (1 - 1e-12));
    return;
  }
  ++tally.divided;
  CHECK(levels > 0);
  CHECK(facets.size() > bucket_size);
  const CellWalls walls(shapes, part.box, facets);
  const double width = (part.box.high[part.axis] - part.box.low[part.axis]) / 32;
  const auto place = static_cast<int>(std::lround((part.wall - part.box.low[part.axis]) / width));
  CHECK(part.wall == walls.wall(part.axis, place));
  const double cost = walls.cost(part.axis, place);
  CHECK(cost < size);
  CHECK(cost <= walls.least() * (1 + 1e-12));
  software::Counting count;
  for (const std::uint32_t half : {part.low, part.high}) {
    List own;
    for (const std::uint32_t facet : facets) {
      if (shapes.touches(facet, parts[half].box, count)) own.push_back(facet);
    }
    check_kd_tree(shapes, bucket_size, parts, half, own, levels - 1, tally);
  }
}

/// Returns the facets of the leaves, lower halves first.
std::vector<List> leaves_of(const software::Directory& directory) {
  const std::vector<SpaceBox> boxes = directory.boxes();
  std::vector<List> leaves;
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const SpaceBox& box = boxes[waiting.back()];
    waiting.pop_back();
    if (box.low == 0) {
      leaves.emplace_back(box.facets.begin(), box.facets.end());
      continue;
    }
    waiting.push_back(box.low + 1);
    waiting.push_back(box.low);
  }
  return leaves;
}

struct NoStop final : software::CellVisitor {
  bool visit(const software::Cell& /*cell*/) override { return true; }
};

void send_ray(const software::Directory& directory, const glm::dvec3& origin, const glm::dvec3& direction) {
  NoStop visitor;
  software::Uncounted nothing;
  directory.walk({origin, direction, 0, 1e9}, visitor, nothing);
}

}  // namespace

TEST_CASE("boxes around facets are divided at the cheapest of all bin divisions") {
  std::size_t divided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const software::Facets facets = any_triangles(random);
    divided += check_heuristic_boxes(software::FacetShapes(facets), static_cast<std::uint32_t>(1 + random.below(5)));
  }
  CHECK(divided > 400);
}
TEST_CASE("a box with more facets than a bucket is divided unless all middles coincide") {
  const auto leaves = [](std::size_t apart, std::uint32_t bucket_size) {
    std::vector<Polygons> primitives(4, {triangle_at({0, 0, 0})});
    for (std::size_t i = 0; i < apart; ++i) primitives.push_back({triangle_at({0, 0, 3})});
    const software::Facets facets = primitives_of(primitives);
    const software::FacetShapes shapes(facets);
    const auto directory = software::directory_of("bvh").make(shapes, {bucket_size});
    return std::pair{leaves_of(*directory), directory->built().overflows};
  };
  CHECK(leaves(0, 4) == std::pair{std::vector<List>{{0, 1, 2, 3}}, std::uint64_t{0}});
  CHECK(leaves(0, 3) == std::pair{std::vector<List>{{0, 1, 2, 3}}, std::uint64_t{1}});
  CHECK(leaves(1, 5) == std::pair{std::vector<List>{{0, 1, 2, 3, 4}}, std::uint64_t{0}});
  CHECK(leaves(1, 4) == std::pair{std::vector<List>{{0, 1, 2, 3}, {4}}, std::uint64_t{0}});
  CHECK(leaves(2, 1) == std::pair{std::vector<List>{{0, 1, 2, 3}, {4, 5}}, std::uint64_t{2}});
}
TEST_CASE("a k-d cell is divided by the cheapest of 31 walls per axis if that saves cost") {
  KdTally tally;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const software::Facets facets = any_triangles(random);
    const software::FacetShapes shapes(facets);
    const auto bucket_size = static_cast<std::uint32_t>(1 + random.below(5));
    const auto directory = software::directory_of("kd-tree").make(shapes, {bucket_size});
    const List all(shapes.placed().begin(), shapes.placed().end());
    const auto levels = static_cast<unsigned>(8 + 1.3 * static_cast<double>(std::bit_width(all.size())));
    check_kd_tree(shapes, bucket_size, directory->parts(), 0, all, levels, tally);
  }
  MESSAGE(tally.divided, " divided, ", tally.not_cheaper, " not cheaper, ", tally.deepest, " at the last level");
  CHECK(tally.divided > 1000);
  CHECK(tally.not_cheaper > 100);
}
TEST_CASE("a k-d tree of n facets has at most 8 levels and 1.3 more per bit of n") {
  // Two facets are so close to each other that a wall cuts off empty space at every level; all others are far away.
  for (const auto& row : {std::pair{3U, 10U}, std::pair{4U, 11U}, std::pair{7U, 11U}, std::pair{8U, 13U}}) {
    const unsigned facets = row.first;
    const unsigned levels = row.second;
    CAPTURE(facets);
    const glm::dvec3 apart{1e-9, 1e-9, 1e-9};
    std::vector<Polygons> primitives{{{glm::dvec3{0}, apart * 0.1, apart * glm::dvec3{0.1, 0, 0.1}}},
                                     {{apart, apart * 1.1, apart * glm::dvec3{1.1, 1, 1.1}}}};
    while (primitives.size() < facets) primitives.push_back({triangle_at({9, 9, 9})});
    const software::Facets all = primitives_of(primitives);
    const software::FacetShapes shapes(all, 1e-12);
    for (const std::uint32_t bucket_size : {1U, 2U}) {
      const auto directory = software::directory_of("kd-tree").make(shapes, {bucket_size});
      const std::vector<SpacePart> parts = directory->parts();
      std::vector<unsigned> depths(parts.size());
      unsigned deepest = 0;
      // A part precedes its halves.
      for (std::size_t i = 0; i < parts.size(); ++i) {
        deepest = std::max(deepest, depths[i]);
        if (!parts[i].is_cell()) depths[parts[i].low] = depths[parts[i].high] = depths[i] + 1;
      }
      if (bucket_size == 1) CHECK(deepest == levels);
      if (bucket_size == 2) CHECK(deepest < levels);
    }
  }
}
TEST_CASE("boxes around primitives are halved along the first of their longest axes") {
  struct Row {
    glm::dvec3 apart;  ///< offset of the second primitive from the first
    bool is_first_below;
  };
  // The boxes are as long as the distance between the triangles plus one unit.
  for (const Row& row : {Row{{5, -3, -2}, true}, Row{{-5, 3, 2}, false}, Row{{-3, 5, -2}, true}, Row{{3, -5, 2}, false},
                         Row{{-2, -3, 5}, true}, Row{{-3, -2, 5}, true}, Row{{2, 3, -5}, false}, Row{{3, 2, -5}, false},
                         Row{{5, -5, -2}, true}, Row{{5, -2, -5}, true}, Row{{-2, 5, -5}, true}, Row{{5, -5, -5}, true},
                         Row{{-5, 5, 5}, false}, Row{{0, 0, 0}, true}}) {
    CAPTURE(row.apart.x);
    CAPTURE(row.apart.y);
    CAPTURE(row.apart.z);
    const software::Facets facets = primitives_of({{triangle_at({0, 0, 0})}, {triangle_at(row.apart)}});
    const software::FacetShapes shapes(facets);
    const auto directory = software::directory_of("boxes").make(shapes, {8});
    CHECK(leaves_of(*directory) == (row.is_first_below ? std::vector<List>{{0}, {1}} : std::vector<List>{{1}, {0}}));
    CHECK(directory->boxes()[0].box == box_around(shapes, {0, 1}));
  }
}
TEST_CASE("boxes are halved at the middle primitive and expanded to facets on demand") {
  // Five primitives from x = 40 down to x = 0, with 2, 3, 1, 2 and 1 facets. The lower half has two primitives.
  const std::vector<std::size_t> sizes{2, 3, 1, 2, 1};
  std::vector<Polygons> primitives;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Polygons polygons;
    for (std::size_t j = 0; j < sizes[i]; ++j)
      polygons.push_back(triangle_at({40 - 10 * static_cast<double>(i), 0, 2 * static_cast<double>(j)}));
    primitives.push_back(polygons);
  }
  const software::Facets facets = primitives_of(primitives);
  const software::FacetShapes shapes(facets);
  const auto directory = software::directory_of("boxes").make(shapes, {8});
  using Leaves = std::vector<List>;
  CHECK(leaves_of(*directory) == Leaves{{8}, {6, 7}, {5}, {2, 3, 4}, {0, 1}});
  CHECK(directory->built().splits == 4);
  const std::vector<SpaceBox> boxes = directory->boxes();
  CHECK(facets_below(boxes, boxes[boxes[0].low]) == List{6, 7, 8});
  CHECK(boxes[0].box == box_around(shapes, {0, 1, 2, 3, 4, 5, 6, 7, 8}));
  CHECK(boxes[boxes[0].low].box == box_around(shapes, {6, 7, 8}));
  // A ray that meets only the primitive of one facet expands nothing, so the counts stay equal.
  const software::SpaceBuilt before = directory->built();
  send_ray(*directory, {20.5, -5, 0.5}, {0, 1, 0});
  send_ray(*directory, {20.5, -5, 0.5}, {0, 1, 0});
  CHECK(directory->built().operations == before.operations);
  CHECK(directory->built().entries == before.entries);
  // The primitive of three facets is longest along z, and is split into one and two facets.
  send_ray(*directory, {30.5, -5, 0.5}, {0, 1, 0});
  CHECK(leaves_of(*directory) == Leaves{{8}, {6, 7}, {5}, {2}, {3}, {4}, {0, 1}});
  CHECK(directory->built().splits == 6);
  const std::vector<SpaceBox> expanded = directory->boxes();
  CHECK(expanded.size() == boxes.size() + 4);
  for (const SpaceBox& box : expanded) CHECK(box.box == box_around(shapes, facets_below(expanded, box)));
  // A second ray expands nothing.
  const software::SpaceBuilt after = directory->built();
  send_ray(*directory, {30.5, -5, 0.5}, {0, 1, 0});
  CHECK(directory->built().operations == after.operations);
  send_ray(*directory, {-5, 0.5, 0.5}, {1, 0, 0});
  CHECK(leaves_of(*directory) == Leaves{{8}, {6}, {7}, {5}, {2}, {3}, {4}, {0}, {1}});
  CHECK(directory->built().most_facets == 1);
}
