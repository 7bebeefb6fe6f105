// Judges: the cells along a ray found by clipping it to all cells, and neighbourhoods of cells by hand.

#include <glm/vec3.hpp>

#include "sim/software/space/directory.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::SpaceRay;
using testing::Random;

namespace {

using Corners = std::vector<glm::dvec3>;

software::Facets facets_with(const std::vector<Corners>& polygons) {
  software::Facets facets;
  for (const Corners& corners : polygons) {
    const auto number = static_cast<std::uint32_t>(facets.facets.size());
    facets.of_primitives.push_back(number);
    facets.facets.push_back({number, {}, facets.corners.size(), facets.corners.size() + corners.size()});
    facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
  }
  facets.of_primitives.push_back(polygons.size());
  return facets;
}

software::Facets scattered_triangles(Random& random, double stretch) {
  const auto somewhere = [&](double size) {
    return glm::dvec3{(random.unit() - 0.5) * stretch, random.unit() - 0.5, random.unit() - 0.5} * size;
  };
  std::vector<Corners> polygons;
  for (std::uint64_t i = 20 + random.below(60); i > 0; --i) {
    const glm::dvec3 place = somewhere(10);
    polygons.push_back({place, place + somewhere(3), place + somewhere(3)});
  }
  return facets_with(polygons);
}

/// A cell or a leaf's box, and its facets.
struct SolidCell {
  facet::Box box;
  std::vector<std::uint32_t> facets;
};

/// About four cells per bucket of facets, as close to cubes as integer counts allow.
std::vector<SolidCell> grid_cells(const software::FacetShapes& shapes, std::uint32_t bucket_size) {
  const facet::Box& box = shapes.box();
  const glm::dvec3 size = box.high - box.low;
  const double wanted = std::max(1.0, 4.0 * static_cast<double>(shapes.placed().size()) / bucket_size);
  const double edge = std::cbrt(size.x * size.y * size.z / wanted);
  std::array<int, 3> cells{};
  for (int axis = 0; axis < 3; ++axis)
    cells[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(std::round(size[axis] / edge), 1.0, 128.0));
  std::vector<SolidCell> all;
  software::Counting count;
  for (int x = 0; x < cells[0]; ++x) {
    for (int y = 0; y < cells[1]; ++y) {
      for (int z = 0; z < cells[2]; ++z) {
        const glm::dvec3 width = size / glm::dvec3{cells[0], cells[1], cells[2]};
        const glm::dvec3 low = box.low + width * glm::dvec3{x, y, z};
        SolidCell cell{{low, low + width}, {}};
        for (const std::uint32_t facet : shapes.placed()) {
          if (shapes.touches(facet, cell.box, count)) cell.facets.push_back(facet);
        }
        all.push_back(cell);
      }
    }
  }
  return all;
}

std::vector<SolidCell> cells_of(const std::string& name, const software::FacetShapes& shapes,
                                std::uint32_t bucket_size) {
  if (name == "grid") return grid_cells(shapes, bucket_size);
  const auto halving = software::directory_of(name == "excell-recursive" ? "excell" : name).make(shapes, {bucket_size});
  std::vector<SolidCell> cells;
  for (const software::SpacePart& part : halving->parts()) {
    if (part.is_cell()) cells.push_back({part.box, {part.facets.begin(), part.facets.end()}});
  }
  return cells;
}

/// Returns the part of a ray inside a box; nothing if the ray misses it.
std::optional<std::pair<double, double>> stay_in(const facet::Box& box, const SpaceRay& ray) {
  std::pair stay{ray.begin, ray.end};
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
    stay.first = std::max(stay.first, std::min(a, b));
    stay.second = std::min(stay.second, std::max(a, b));
  }
  return stay;
}

/// A cell reported or expected.
struct ReportedCell {
  double in;
  double out;
  double settled;
  std::vector<std::uint32_t> facets;
};

class Listener final : public software::CellVisitor {
 public:
  explicit Listener(std::size_t enough = std::numeric_limits<std::size_t>::max()) : enough_(enough) {}

  bool visit(const software::Cell& cell) override {
    reported.push_back({cell.t_in, cell.t_out, cell.settled, {cell.facets.begin(), cell.facets.end()}});
    std::ranges::sort(reported.back().facets);
    return reported.size() < enough_;
  }

  std::vector<ReportedCell> reported;

 private:
  std::size_t enough_;
};

std::vector<ReportedCell> cells_along(const software::Directory& directory, const SpaceRay& ray) {
  Listener listener;
  software::Uncounted nothing;
  directory.walk(ray, listener, nothing);
  return listener.reported;
}

/// A ray through space along or across axes, from outside or inside, in part of the cases with ends.
SpaceRay ray_through(Random& random, const facet::Box& box) {
  const auto somewhere = [&](double beyond) {
    const glm::dvec3 part{random.unit(), random.unit(), random.unit()};
    return box.low + (part * (1 + 2 * beyond) - beyond) * (box.high - box.low);
  };
  SpaceRay ray{somewhere(random.below(2) == 0 ? 0.5 : 0), {0, 0, 0}, 0, 1e9};
  ray.direction = somewhere(0) - ray.origin;
  const std::uint64_t kind = random.below(4);
  if (kind == 0) ray.direction[static_cast<int>(random.below(3))] = 0;
  if (kind == 1) {
    ray.direction = {0, 0, 0};
    ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 3 : -3;
  }
  if (random.below(3) == 0) ray.end = random.unit();
  if (random.below(3) == 0) ray.begin = ray.end == 1e9 ? random.unit() : ray.end * random.unit();
  return ray;
}

/// Returns the cells along a ray in order; nothing if the ray is too short in one to decide.
std::optional<std::vector<ReportedCell>> expected_along(const std::vector<SolidCell>& cells, const SpaceRay& ray) {
  std::vector<ReportedCell> expected;
  for (const SolidCell& cell : cells) {
    const auto stay = stay_in(cell.box, ray);
    if (!stay || stay->second < stay->first - 1e-9) continue;
    if (stay->second < stay->first + 1e-9) return std::nullopt;
    expected.push_back({stay->first, stay->second, stay->second, cell.facets});
    std::ranges::sort(expected.back().facets);
  }
  std::ranges::sort(expected, {}, &ReportedCell::in);
  return expected;
}

void check_cells(const std::vector<ReportedCell>& reported, const std::vector<ReportedCell>& expected) {
  REQUIRE(reported.size() == expected.size());
  for (std::size_t i = 0; i < reported.size(); ++i) {
    CHECK(std::abs(reported[i].in - expected[i].in) < 1e-10);
    CHECK(std::abs(reported[i].out - expected[i].out) < 1e-10);
    CHECK(std::abs(reported[i].settled - expected[i].settled) < 1e-10);
    CHECK(reported[i].facets == expected[i].facets);
  }
}

/// Checks that leaves come in the order in which the ray enters them, and that each settles no more than the next one's
/// start.
void check_box_leaves(const software::Directory& directory, const SpaceRay& ray) {
  (void)cells_along(directory, ray);  // builds the parts that are built on demand
  const std::vector<ReportedCell> reported = cells_along(directory, ray);
  std::vector<SolidCell> leaves;
  for (const software::SpaceBox& box : directory.boxes()) {
    if (box.low == 0) leaves.push_back({box.box, {box.facets.begin(), box.facets.end()}});
  }
  std::vector<ReportedCell> expected;
  for (const SolidCell& leaf : leaves) {
    const auto stay = stay_in(leaf.box, ray);
    if (!stay || stay->second < stay->first) continue;
    if (std::abs(stay->second - stay->first) < 1e-9) return;
    expected.push_back({stay->first, stay->second, 0, leaf.facets});
    std::ranges::sort(expected.back().facets);
  }
  REQUIRE(reported.size() == expected.size());
  for (std::size_t i = 0; i < reported.size(); ++i) {
    CHECK(std::ranges::count_if(expected, [&](const ReportedCell& one) {
            return one.facets == reported[i].facets && std::abs(one.in - reported[i].in) < 1e-10 &&
                   std::abs(one.out - reported[i].out) < 1e-10;
          }) == 1);
    const bool is_last = i + 1 == reported.size();
    CHECK(reported[i].settled >= reported[i].in);
    if (!is_last) CHECK(reported[i].in <= reported[i + 1].in);
    if (!is_last) CHECK(reported[i].settled <= reported[i + 1].in);
  }
}

/// Rotates the coordinates cyclically.
glm::dvec3 turned(const glm::dvec3& place, int turn) {
  return {place[turn % 3], place[(turn + 1) % 3], place[(turn + 2) % 3]};
}

}  // namespace

TEST_CASE("a ray visits its cells in order from each entry to each exit") {
  std::size_t cells = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const software::Facets facets = scattered_triangles(random, seed % 3 == 0 ? 5 : 1);
    const software::FacetShapes shapes(facets);
    const auto bucket_size = static_cast<std::uint32_t>(2 + random.below(8));
    for (const char* const name : {"excell", "excell-recursive", "octree", "kd-tree", "grid"}) {
      CAPTURE(seed);
      CAPTURE(name);
      const std::vector<SolidCell> all = cells_of(name, shapes, bucket_size);
      const auto directory = software::directory_of(name).make(shapes, {bucket_size});
      for (int i = 0; i < 30; ++i) {
        const SpaceRay ray = ray_through(random, shapes.box());
        const auto expected = expected_along(all, ray);
        if (!expected) continue;
        cells += expected->size();
        const std::vector<ReportedCell> reported = cells_along(*directory, ray);
        check_cells(reported, *expected);
        // A visitor that has stopped receives no more cells.
        if (reported.size() < 2) continue;
        Listener listener(reported.size() - 1);
        software::Counting counting;
        directory->walk(ray, listener, counting);
        CHECK(listener.reported.size() == reported.size() - 1);
      }
    }
    for (const char* const name : {"bvh", "boxes"}) {
      CAPTURE(seed);
      CAPTURE(name);
      const auto directory = software::directory_of(name).make(shapes, {bucket_size});
      for (int i = 0; i < 30; ++i) check_box_leaves(*directory, ray_through(random, shapes.box()));
    }
  }
  CHECK(cells > 4000);
}
TEST_CASE("a ray that begins or ends on a wall between cells visits no cell beyond it") {
  std::vector<Corners> polygons;
  for (const double x : {-7.5, 7.5, -7.25, 7.25}) polygons.push_back({{x, -1, -1}, {x, 1, -1}, {x, 1, 1}, {x, -1, 1}});
  const software::Facets facets = facets_with(polygons);
  const software::FacetShapes shapes(facets, 0.25);
  REQUIRE(shapes.box() == facet::Box{{-8, -1.5, -1.5}, {8, 1.5, 1.5}});
  for (const char* const name : {"excell-recursive", "kd-tree", "grid"}) {
    CAPTURE(name);
    const auto directory = software::directory_of(name).make(shapes, {2});
    // EXCELL halves the box along x; a grid of 6 cells along x also has its third wall there.
    const double wall = std::string(name) == "kd-tree" ? directory->parts()[0].wall : 0;
    const auto reported = [&](double from, double along, double end) {
      Listener listener;
      software::Counting count;
      directory->walk({{from, 0.25, 0.25}, {along, 0, 0}, 0, end}, listener, count);
      std::vector<std::vector<std::uint32_t>> all;
      for (const ReportedCell& cell : listener.reported) all.push_back(cell.facets);
      return std::pair{all, count.done()};
    };
    constexpr double little = 0x1p-20;
    CHECK(reported(wall, 1, 99) == reported(wall + little, 1, 99));
    CHECK(reported(wall - 1, 1, 1) == reported(wall - 1, 1, 1 - little));
    CHECK(reported(wall + 1, -1, 1) == reported(wall + 1, -1, 1 - little));
    if (std::string(name) != "grid") CHECK(reported(wall, -1, 99) == reported(wall - little, -1, 99));
    CHECK(reported(wall - 1, 1, 99).first.size() > reported(wall, 1, 99).first.size());
  }
}
TEST_CASE("the directory `none` has all facets in one cell along the whole ray") {
  Random random(3);
  const software::Facets facets = scattered_triangles(random, 1);
  const software::FacetShapes shapes(facets);
  const auto none = software::directory_of("none").make(shapes, {4});
  const std::vector<ReportedCell> reported = cells_along(*none, {{90, 90, 90}, {1, 0, 0}, 2, 7});
  REQUIRE(reported.size() == 1);
  CHECK(reported[0].in == 2);
  CHECK(reported[0].out == 7);
  CHECK(reported[0].settled == std::numeric_limits<double>::infinity());
  CHECK(reported[0].facets.size() == facets.facets.size());
  const software::SpaceBuilt built = none->built();
  CHECK(built.cells == 1);
  CHECK(built.references == facets.facets.size());
  CHECK(built.most_facets == facets.facets.size());
  CHECK(built.bucket_words == facets.facets.size());
  CHECK(built.entries == 0);
  CHECK(built.directory_words == 0);
}
TEST_CASE("a grid has four cells per bucket and 1 to 128 along an axis") {
  // The reach, added twice around all facets, is negligible.
  const auto cells = [](const std::vector<Corners>& polygons, std::uint32_t bucket_size) {
    const software::Facets facets = facets_with(polygons);
    const software::FacetShapes shapes(facets, 1e-9);
    return software::directory_of("grid").make(shapes, {bucket_size})->built().cells;
  };
  const Corners low{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Corners high{{4, 4, 4}, {3, 4, 4}, {4, 3, 4}};
  CHECK(cells({low, high}, 1) == 2 * 2 * 2);
  CHECK(cells({low, high}, 8) == 1);
  CHECK(cells({low, high}, 100) == 1);
  CHECK(cells({low, low, low, high, high, high, high}, 1) == 3 * 3 * 3);  // 4 per facet: 28 requested
  // Twice as long along one axis: 16 cells are requested and made, 4 by 2 by 2.
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<Corners> polygons{low, low, high, high};
    for (Corners& corners : polygons) {
      for (glm::dvec3& corner : corners) corner = turned(corner * glm::dvec3{2, 1, 1}, turn);
    }
    CHECK(cells(polygons, 1) == 4 * 2 * 2);
    for (Corners& corners : polygons) {
      for (glm::dvec3& corner : corners) corner = corner * turned({1e6, 1, 1}, turn);
    }
    CHECK(cells(polygons, 1) == 128);
  }
  CHECK(cells({}, 8) == 0);
  CHECK(cells({{}}, 8) == 0);
}
TEST_CASE("each facet is enlarged by the reach and the total box by twice the reach") {
  const software::Facets facets =
      facets_with({{{1, 2, 3}, {2, 2, 3}, {1, 4, 8}}, {}, {{-4, 5, 3}}, {{0, 0, 0}, {3, 0, 1}}});
  const software::FacetShapes shapes(facets, 0.5);
  CHECK(shapes.reach() == 0.5);
  CHECK(shapes.box_of(0) == facet::Box{{0.5, 1.5, 2.5}, {2.5, 4.5, 8.5}});
  CHECK(shapes.box_of(2) == facet::Box{{-4.5, 4.5, 2.5}, {-3.5, 5.5, 3.5}});
  CHECK(shapes.box_of(3) == facet::Box{{-0.5, -0.5, -0.5}, {3.5, 0.5, 1.5}});
  CHECK(shapes.box() == facet::Box{{-5, -1, -1}, {4, 6, 9}});
  CHECK(std::vector<std::uint32_t>(shapes.placed().begin(), shapes.placed().end()) ==
        std::vector<std::uint32_t>{0, 2, 3});
  CHECK(std::vector<std::uint32_t>(shapes.unplaced().begin(), shapes.unplaced().end()) ==
        std::vector<std::uint32_t>{1});
  // The default is 2^-14 of the diagonal, which is 13 for extents of 3, 4 and 12.
  const software::Facets others = facets_with({{{1, 1, 1}, {4, 5, 13}, {4, 1, 1}}});
  CHECK(software::FacetShapes(others).reach() == 13 * 0x1p-14);
  const software::Facets none;
  CHECK(software::FacetShapes(none).box().empty());
}
TEST_CASE("a facet touches a box exactly if they are within the reach along every axis") {
  // The reach is 1/4. Each box touches the facet exactly, and not after a displacement by `away` along `axis`.
  struct Row {
    const char* what;
    Corners corners;
    facet::Box box;  ///< touches exactly
    int axis;        ///< axis of the displacement
    double away;     ///< displacement after which it does not touch
  };
  const double little = 0x1p-40;
  const Corners square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const Corners corner_off{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<Row> rows{
      {"above a face", square, {{-1, -1, 0.25}, {1, 1, 2}}, 2, little},
      {"below a face", square, {{-1, -1, -2}, {1, 1, -0.25}}, 2, -little},
      {"beside a side", square, {{1.25, -1, -1}, {3, 1, 1}}, 0, little},
      {"beside a side", square, {{-3, -1, -1}, {-1.25, 1, 1}}, 0, -little},
      {"beside a corner", square, {{1.25, 1.25, -1}, {3, 3, 1}}, 1, little},
      {"beyond a slanting side", corner_off, {{3, 1.5, -1}, {4, 3, 1}}, 1, little},
      {"beyond a slanting side", corner_off, {{2.5, 2, -1}, {4, 3, 1}}, 0, little},
      // A face in the plane x = z; the box touches it with its edge at x = 1/2, z = 0.
      {"before a slanting face",
       {{-1, -1, -1}, {-1, 1, -1}, {1, 1, 1}, {1, -1, 1}},
       {{0.5, -1, -1}, {1, 1, 0}},
       2,
       -1e-9},
      {"beside an edge alone", {{0, 0, 0}, {4, 4, 0}}, {{2, 0, -1}, {3, 1.5, 1}}, 1, -little},
      {"beside a corner alone", {{0, 0, 0}}, {{0.25, 0.25, 0.25}, {1, 1, 1}}, 2, little},
  };
  for (const Row& row : rows) {
    for (int turn = 0; turn < 3; ++turn) {
      for (const bool is_turned_over : {false, true}) {
        CAPTURE(row.what);
        CAPTURE(turn);
        CAPTURE(is_turned_over);
        Corners corners;
        for (const glm::dvec3& corner : row.corners) corners.push_back(turned(corner, turn));
        if (is_turned_over) std::ranges::reverse(corners);
        const software::Facets facets = facets_with({corners});
        const software::FacetShapes shapes(facets, 0.25);
        facet::Box box = row.box;
        software::Counting count;
        // Rounding may only add contacts, and does for the slanting plane, whose `away` is therefore larger.
        CHECK(shapes.touches(0, {turned(box.low, turn), turned(box.high, turn)}, count));
        box.low[row.axis] += row.away;
        box.high[row.axis] += row.away;
        CHECK(!shapes.touches(0, {turned(box.low, turn), turned(box.high, turn)}, count));
      }
    }
  }
}
TEST_CASE("new statistics are 0, options have defaults, empty directories have no facets") {
  const software::SpaceBuilt built;
  CHECK(built.cells + built.entries + built.references + built.most_facets + built.overflows + built.splits +
            built.overlap_tests + built.directory_words + built.bucket_words ==
        0);
  CHECK(software::SpaceOptions{}.bucket_size == 8);
  const software::SpaceRay ray;
  CHECK((ray.origin == glm::dvec3{0} && ray.direction == glm::dvec3{0} && ray.begin == 0 && ray.end == 0));
  CHECK(software::SpaceRay{{1, 2, 3}, {2, 0, -4}, 0, 0}.at(1.5) == glm::dvec3{4, 2, -3});
  CHECK(software::SpacePart{}.is_cell());
  CHECK(!software::SpacePart{.box = {}, .low = 1}.is_cell());
  // A model without facets has at most one empty cell.
  const software::Facets none;
  const software::FacetShapes shapes(none);
  for (const software::DirectoryRow* const row : software::directories()) {
    CAPTURE(row->name);
    const auto directory = row->make(shapes, {4});
    CHECK(directory->built().references == 0);
    CHECK(directory->built().splits == 0);
    CHECK(directory->built().cells == (row->name == "grid" ? 0U : 1U));
    for (const ReportedCell& cell : cells_along(*directory, {{-1, 0, 0}, {1, 0, 0}, 0, 9})) CHECK(cell.facets.empty());
  }
}
