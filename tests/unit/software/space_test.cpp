#include <rapidcheck.h>

#include "sim/software/space/directory.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::SpaceRay;
using testing::Random;

namespace {

double unit(Random& random) { return static_cast<double>(random.below(1U << 30U)) / (1U << 30U); }
double between(Random& random, double low, double high) { return low + (high - low) * unit(random); }
glm::dvec3 somewhere(Random& random, double size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

void add(software::Facets& facets, const std::vector<glm::dvec3>& corners) {
  const auto number = static_cast<std::uint32_t>(facets.facets.size());
  facets.of_primitives.push_back(number);
  facets.facets.push_back({number, {}, facets.corners.size(), facets.corners.size() + corners.size()});
  facets.corners.insert(facets.corners.end(), corners.begin(), corners.end());
}

/// A polygon around a point: an ellipse with a random number of corners.
std::vector<glm::dvec3> polygon(Random& random, const glm::dvec3& middle, double radius, double thickness) {
  const glm::dvec3 a = glm::normalize(somewhere(random, 1) + glm::dvec3{0, 0, 1e-3});
  const glm::dvec3 b = glm::normalize(glm::cross(a, somewhere(random, 1) + glm::dvec3{1e-3, 0, 0}));
  const auto corners = 3 + random.below(10);
  std::vector<glm::dvec3> all;
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    all.push_back(middle + a * (radius * std::cos(angle)) + b * (radius * thickness * std::sin(angle)));
  }
  return all;
}

constexpr const char* kinds[] = {"anywhere", "slivers", "through one edge",      "in one place", "flat",
                                 "far",      "few",     "with edges and corners"};

software::Facets any_facets(Random& random, std::uint64_t kind) {
  software::Facets facets;
  const std::uint64_t number = kind == 6 ? random.below(3) : 20 + random.below(80);
  const glm::dvec3 far = kind == 5 ? somewhere(random, 1e5) : glm::dvec3{0};
  for (std::uint64_t i = 0; i < number; ++i) {
    const double radius = between(random, 0.05, 4);
    switch (kind) {
      case 1: add(facets, polygon(random, somewhere(random, 5), radius, 1e-7)); break;
      case 2: add(facets, {{0, 0, -3}, {0, 0, 3}, somewhere(random, 5)}); break;
      case 3: add(facets, polygon(random, somewhere(random, i == 0 ? 5 : 1e-6), i == 0 ? 1 : 1e-6, 1)); break;
      case 4: {
        std::vector<glm::dvec3> corners{somewhere(random, 5), somewhere(random, 5), somewhere(random, 5)};
        for (glm::dvec3& corner : corners) corner.y = 1;
        add(facets, corners);
        break;
      }
      case 7:
        if (i % 3 == 0) add(facets, {somewhere(random, 5)});
        if (i % 3 == 1) add(facets, {somewhere(random, 5), somewhere(random, 5)});
        if (i % 3 == 2) add(facets, polygon(random, somewhere(random, 5), radius, 1));
        break;
      default: add(facets, polygon(random, far + somewhere(random, 5), radius, between(random, 0.1, 1)));
    }
  }
  facets.of_primitives.push_back(number);
  return facets;
}

/// The position of a random wall that halving up to five times gives, or of an end of the range.
double wall(Random& random, double low, double high) {
  const std::uint64_t cells = std::uint64_t{1} << (1 + random.below(5));
  return low + (high - low) * static_cast<double>(random.below(cells + 1)) / static_cast<double>(cells);
}

glm::dvec3 crossing(Random& random, const facet::Box& box) {
  return {wall(random, box.low.x, box.high.x), wall(random, box.low.y, box.high.y),
          wall(random, box.low.z, box.high.z)};
}

SpaceRay any_ray(Random& random, const software::Facets& facets, const facet::Box& box) {
  const double size = box.empty() ? 1 : box.diagonal();
  const glm::dvec3 middle = box.empty() ? glm::dvec3{0} : box.centre();
  SpaceRay ray{middle + somewhere(random, size), somewhere(random, 1), 0, std::numeric_limits<double>::infinity()};
  const glm::dvec3 inside = middle + somewhere(random, size / 4);
  switch (random.below(8)) {
    case 0: break;                       // may miss the box
    case 1: ray.origin = inside; break;  // starts in the box
    case 2: ray.direction = inside - ray.origin; break;
    case 3:  // along walls
      ray.origin = crossing(random, box);
      ray.direction = {0, 0, 0};
      ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? size : -size;
      ray.begin = -2;
      break;
    case 4: ray.direction = crossing(random, box) - ray.origin; break;  // through corners of cells
    case 5:
      ray.origin = crossing(random, box);
      ray.direction = crossing(random, box) - ray.origin;
      ray.begin = -3;
      break;
    case 6:  // through a corner of a facet, or near it
      if (!facets.corners.empty()) ray.direction = facets.corners[random.below(facets.corners.size())] - ray.origin;
      break;
    default:  // in a plane along a wall
      ray.direction = inside - ray.origin;
      ray.direction[static_cast<int>(random.below(3))] = 0;
      ray.end = between(random, 0, 2);
  }
  if (ray.direction == glm::dvec3{0}) ray.direction = {size, 0, 0};
  return ray;
}

/// Returns where a ray certainly meets a facet, not near its edges: triangle by triangle, in long doubles.
std::optional<double> met_at(const SpaceRay& ray, std::span<const glm::dvec3> corners) {
  using Vector = glm::vec<3, long double>;
  const Vector origin(ray.origin);
  const Vector direction(ray.direction);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vector a = Vector(corners[i - 1]) - Vector(corners[0]);
    const Vector b = Vector(corners[i]) - Vector(corners[0]);
    const Vector across = glm::cross(direction, b);
    const long double determinant = glm::dot(a, across);
    if (determinant == 0) continue;
    const Vector to = origin - Vector(corners[0]);
    const long double u = glm::dot(to, across) / determinant;
    const Vector other = glm::cross(to, a);
    const long double v = glm::dot(direction, other) / determinant;
    const long double t = glm::dot(b, other) / determinant;
    if (u > 0 && v > 0 && u + v < 1 && t >= ray.begin && t <= ray.end) return static_cast<double>(t);
  }
  return std::nullopt;
}

/// Records the reported cells.
class RecordingVisitor final : public software::CellVisitor {
 public:
  bool visit(const software::Cell& cell) override {
    cells.push_back({cell.t_in, cell.t_out, cell.settled, {}});
    facets.emplace_back(cell.facets.begin(), cell.facets.end());
    return true;
  }

  std::vector<software::Cell> cells;
  std::vector<std::vector<std::uint32_t>> facets;
};

struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t cells = 0;
  std::uint64_t hits = 0;
};

/// Returns the fault in a ray's reported cells, judged by all facets; empty if none.
std::string find_fault(const software::Facets& facets, const SpaceRay& ray, const RecordingVisitor& visitor,
                       double size, Tally& tally) {
  const double slack = 1e-9 * size / glm::length(ray.direction);
  double before = -std::numeric_limits<double>::infinity();
  std::vector<double> reported_after(facets.facets.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < visitor.cells.size(); ++i) {
    const software::Cell& cell = visitor.cells[i];
    if (cell.settled < before) return fmt::format("cell {} settles less than its predecessor", i);
    if (cell.t_in > cell.t_out + slack) return fmt::format("cell {} is left before it is entered", i);
    for (const std::uint32_t facet : visitor.facets[i]) reported_after[facet] = std::min(reported_after[facet], before);
    before = cell.settled;
  }
  tally.cells += visitor.cells.size();
  for (std::uint32_t i = 0; i < facets.facets.size(); ++i) {
    const std::optional<double> t = met_at(ray, facets.corners_of(i));
    if (!t) continue;
    ++tally.hits;
    if (reported_after[i] > *t + slack)
      return fmt::format("facet {} is met at {} but reported after {} was settled", i, *t, reported_after[i]);
  }
  return "";
}

std::string find_fault(std::uint64_t seed, std::uint64_t kind, Tally& tally) {
  Random random(seed);
  const software::Facets facets = any_facets(random, kind);
  const software::FacetShapes shapes(facets);
  std::vector<std::unique_ptr<software::Directory>> all;
  const software::SpaceOptions options{static_cast<std::uint32_t>(1 + random.below(12))};
  for (const software::DirectoryRow* row : software::directories()) all.push_back(row->make(shapes, options));
  for (int i = 0; i < 20; ++i) {
    const SpaceRay ray = any_ray(random, facets, shapes.box());
    ++tally.rays;
    for (std::size_t one = 0; one < all.size(); ++one) {
      RecordingVisitor visitor;
      software::Uncounted nothing;
      all[one]->walk(ray, visitor, nothing);
      const std::string fault = find_fault(facets, ray, visitor, shapes.box().diagonal(), tally);
      if (!fault.empty())
        return fmt::format("{}, facets {}, seed {}: {}", software::directories()[one]->name, kinds[kind], seed, fault);
    }
  }
  return "";
}

/// Whether a box contains a point of a polygon: clips the polygon by each wall.
bool is_in(const facet::Box& box, std::vector<glm::dvec3> polygon) {
  if (facet::common(box, facet::box_of(polygon)).empty()) return false;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_high : {false, true}) {
      std::vector<glm::dvec3> left;
      const auto inside = [&](const glm::dvec3& one) {
        return is_high ? box.high[axis] - one[axis] : one[axis] - box.low[axis];
      };
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& here = polygon[i];
        const glm::dvec3& next = polygon[(i + 1) % polygon.size()];
        if (inside(here) >= 0) left.push_back(here);
        if ((inside(here) >= 0) != (inside(next) >= 0))
          left.push_back(here + (next - here) * (inside(here) / (inside(here) - inside(next))));
      }
      polygon = std::move(left);
    }
  }
  return !polygon.empty();
}

struct PlainCell {
  facet::Box box;
  std::set<std::uint32_t> facets;
};

/// The cells of EXCELL by its rule alone: halved while they have more facets than a bucket, up to a number of levels.
struct PlainCells {
  unsigned levels = 15;
  unsigned first_levels = 15;  ///< levels of the first directory; a full cell gets its own one
  std::vector<PlainCell> cells{};
  std::uint64_t directories = 1;
  std::uint64_t overflows = 0;
};

void add_cells(const software::Facets& facets, const PlainCell& cell, double reach, unsigned level, std::size_t most,
               PlainCells& cells) {
  if (level == cells.levels || cell.facets.size() <= most) {
    cells.overflows += cell.facets.size() > most ? 1U : 0U;
    cells.cells.push_back(cell);
    return;
  }
  if (level == cells.first_levels) ++cells.directories;
  const int axis = static_cast<int>(level % 3);
  for (const bool is_high : {false, true}) {
    PlainCell half{cell.box, {}};
    (is_high ? half.box.low : half.box.high)[axis] = (cell.box.low[axis] + cell.box.high[axis]) / 2;
    const facet::Box grown{half.box.low - reach, half.box.high + reach};
    for (const std::uint32_t facet : cell.facets) {
      const auto corners = facets.corners_of(facet);
      if (is_in(grown, {corners.begin(), corners.end()})) half.facets.insert(facet);
    }
    add_cells(facets, half, reach, level + 1, most, cells);
  }
}

/// Length of a ray in a box.
double part_in(const facet::Box& box, const SpaceRay& ray) {
  double begin = ray.begin;
  double end = ray.end;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return end - begin;
}

struct RaysInCells {
  std::uint64_t rays = 0;
  std::uint64_t cells = 0;
};

/// Compares both walks through EXCELL with the cells of its rule, which are returned.
PlainCells check_excell(const software::Facets& facets, const software::SpaceOptions& options, PlainCells plain,
                        Random& random, RaysInCells& rays) {
  const software::FacetShapes shapes(facets);
  PlainCell whole{shapes.box(), {}};
  for (std::uint32_t i = 0; i < facets.facets.size(); ++i) whole.facets.insert(i);
  add_cells(facets, whole, shapes.reach(), 0, options.bucket_size, plain);
  std::uint64_t references = 0;
  for (const PlainCell& cell : plain.cells) references += cell.facets.size();
  for (const char* const name : {"excell", "excell-recursive"}) {
    CAPTURE(name);
    const std::unique_ptr<software::Directory> excell = software::directory_of(name).make(shapes, options);
    const software::SpaceBuilt built = excell->built();
    CHECK(built.cells == plain.cells.size());
    CHECK(built.references == references);
    CHECK(built.splits + 1 == plain.cells.size());
    CHECK(built.overflows == plain.overflows);
    // A directory has four words in addition to its entries.
    CHECK(built.directory_words == built.entries + 4 * plain.directories);
    for (int i = 0; i < 30; ++i) {
      const glm::dvec3 origin = somewhere(random, 12);
      glm::dvec3 to = somewhere(random, 4);
      if (i % 2 == 0 && !facets.corners.empty()) to = facets.corners[random.below(facets.corners.size())];
      const SpaceRay ray{origin, to - origin, 0, 1e9};
      std::multiset<std::set<std::uint32_t>> expected;
      bool is_close = false;
      for (const PlainCell& cell : plain.cells) {
        const double part = part_in(cell.box, ray);
        is_close = is_close || std::abs(part) < 1e-9;
        if (part > 0) expected.insert(cell.facets);
      }
      if (is_close) continue;
      ++rays.rays;
      rays.cells += expected.size();
      RecordingVisitor visitor;
      software::Uncounted nothing;
      excell->walk(ray, visitor, nothing);
      std::multiset<std::set<std::uint32_t>> found;
      for (const std::vector<std::uint32_t>& one : visitor.facets) found.emplace(one.begin(), one.end());
      CHECK(found == expected);
    }
  }
  return plain;
}

}  // namespace

TEST_CASE("every directory reports each facet on a ray before settling the ray beyond it") {
  Tally tally;
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t i = 0; i < 2; ++i) {
      const std::string fault = find_fault(seed + i, (seed / 2 + i * 3) % std::size(kinds), tally);
      if (!fault.empty()) RC_FAIL(fault);
    }
  }));
  MESSAGE(tally.rays, " rays, ", tally.cells, " cells, ", tally.hits, " hits");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.hits > tally.rays);
}
TEST_CASE("EXCELL has the cells of a plain recount and both walks report a ray's facets") {
  RaysInCells rays;
  const auto seeds = testing::cases<std::uint64_t>(24, 4);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const software::Facets facets = any_facets(random, 0);
    const software::SpaceOptions options{static_cast<std::uint32_t>(2 + random.below(20))};
    check_excell(facets, options, PlainCells{}, random, rays);
  }
  CHECK((!testing::draws_usual_cases() || rays.rays > 1000));
  CHECK(rays.cells > 2 * rays.rays);
}
TEST_CASE("EXCELL has 15 levels below 4096 facets and otherwise 12 with directories of 9") {
  for (const bool has_two : {false, true}) {
    CAPTURE(has_two);
    Random random(5);
    software::Facets facets;
    // Most are small and scattered; clusters fill cells of the last level.
    const std::uint64_t number = has_two ? 4096 : 4095;
    for (std::uint64_t i = 0; i < number; ++i) {
      glm::dvec3 place = somewhere(random, 5);
      if (i % 64 == 0) place = glm::dvec3{1, 2, 3} + somewhere(random, 0.1);
      if (i % 64 == 1) place = glm::dvec3{-3, -2, 1} + somewhere(random, 1e-3);
      if (i % 64 == 2) place = glm::dvec3{4, -3, -4} + somewhere(random, 0.5);
      add(facets, {place, place + glm::dvec3{2e-3, 0, 1e-3}, place + glm::dvec3{0, 2e-3, 1e-3}});
    }
    facets.of_primitives.push_back(number);
    RaysInCells rays;
    const PlainCells plain = check_excell(facets, {6}, {has_two ? 21U : 15U, has_two ? 12U : 15U}, random, rays);
    CHECK(plain.overflows > 0);
    CHECK((plain.directories > 3) == has_two);
    CHECK(rays.rays > 20);
  }
}
TEST_CASE("a counting walk reports the same cells as one that does not count") {
  Random random(7);
  const software::Facets facets = any_facets(random, 0);
  const software::FacetShapes shapes(facets);
  for (const software::DirectoryRow* row : software::directories()) {
    CAPTURE(row->name);
    const std::unique_ptr<software::Directory> directory = row->make(shapes, {4});
    for (int i = 0; i < 50; ++i) {
      const SpaceRay ray = any_ray(random, facets, shapes.box());
      RecordingVisitor visitor;
      RecordingVisitor counted;
      software::Uncounted nothing;
      software::Counting count;
      directory->walk(ray, visitor, nothing);
      directory->walk(ray, counted, count);
      CHECK(visitor.facets == counted.facets);
      if (row->name != "none") CHECK(count.done() != software::Operations{});
    }
  }
}
TEST_CASE("the parts of halving directories fill space and contain the cells of each facet") {
  REQUIRE(software::halving_directories() == std::vector<std::string>{"excell", "octree", "kd-tree"});
  std::uint64_t cells = 0;
  const auto seeds = static_cast<std::uint64_t>(testing::cases(32, static_cast<int>(std::size(kinds))));
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    Random random(seed);
    const software::Facets facets = any_facets(random, seed % std::size(kinds));
    if (facets.facets.empty()) continue;
    const software::FacetShapes shapes(facets);
    for (const std::string& name : software::halving_directories()) {
      CAPTURE(seed);
      CAPTURE(name);
      const auto directory = software::directory_of(name).make(shapes, {static_cast<std::uint32_t>(1 + seed % 9)});
      const std::vector<software::SpacePart> parts = directory->parts();
      REQUIRE(!parts.empty());
      CHECK(parts.front().box.low == shapes.box().low);
      CHECK(parts.front().box.high == shapes.box().high);
      std::uint64_t visitor = 0;
      for (const software::SpacePart& part : parts) {
        if (!part.is_cell()) {
          facet::Box low = part.box;
          facet::Box high = part.box;
          low.high[part.axis] = high.low[part.axis] = part.wall;
          CHECK((parts[part.low].box.low == low.low && parts[part.low].box.high == low.high));
          CHECK((parts[part.high].box.low == high.low && parts[part.high].box.high == high.high));
          continue;
        }
        ++visitor;
        const std::set<std::uint32_t> has(part.facets.begin(), part.facets.end());
        software::Counting count;
        for (const std::uint32_t facet : shapes.placed())
          CHECK(has.contains(facet) == shapes.touches(facet, part.box, count));
      }
      CHECK(visitor == directory->built().cells);
      cells += visitor;
    }
  }
  CHECK(cells > 5000);
  const software::Facets none;
  for (const software::DirectoryRow* const row : software::directories()) {
    const software::FacetShapes shapes(none);
    if (!row->halves_space) CHECK(row->make(shapes, {})->parts().empty());
  }
}
TEST_CASE("an unknown directory of space is rejected with a list of the valid ones") {
  CHECK(testing::error_of([] { (void)software::directory_of("excel"); }).find("excell") != std::string::npos);
}
