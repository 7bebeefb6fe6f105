// Recounts the costs of building directories and of walking rays through them from facets and cells.

#include "tests/unit/software/recount_space.h"

#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/recount_display.h"

using namespace csgsim;
using software::SpaceRay;
using testing::Operations;
using testing::Random;

namespace {

/// Counts the visited cells and stops the ray at a given number of them.
class LimitedVisitor final : public software::CellVisitor {
 public:
  explicit LimitedVisitor(std::size_t enough) : enough_(enough) {}

  bool visit(const software::Cell& /*cell*/) override { return ++cells < enough_; }
  [[nodiscard]] bool is_stopped() const { return cells == enough_; }

  std::size_t cells = 0;

 private:
  std::size_t enough_;
};

void check_same(const software::SpaceBuilt& found, const software::SpaceBuilt& expected) {
  CHECK(found.cells == expected.cells);
  CHECK(found.entries == expected.entries);
  CHECK(found.references == expected.references);
  CHECK(found.most_facets == expected.most_facets);
  CHECK(found.overflows == expected.overflows);
  CHECK(found.splits == expected.splits);
  CHECK(found.overlap_tests == expected.overlap_tests);
  CHECK(found.directory_words == expected.directory_words);
  CHECK(found.bucket_words == expected.bucket_words);
  testing::check_same(found.operations, expected.operations);
}

/// A ray in any direction, along an axis or across one; some with an end.
SpaceRay any_ray(Random& random, const facet::Box& box) {
  const auto somewhere = [&] {
    const glm::dvec3 part{random.unit(), random.unit(), random.unit()};
    return box.low + (part * 1.5 - 0.25) * (box.high - box.low);
  };
  SpaceRay ray{somewhere(), {0, 0, 0}, 0, random.below(4) == 0 ? random.unit() : 1e9};
  const std::uint64_t kind = random.below(4);
  if (kind == 0) {
    ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
  } else {
    ray.direction = somewhere() - ray.origin;
    if (kind == 1) ray.direction[static_cast<int>(random.below(3))] = 0;
  }
  return ray;
}

/// Returns the number of cells visited by rays.
std::size_t check_walks(const std::string& name, const software::FacetShapes& shapes, std::uint32_t bucket_size,
                        const software::Directory& directory, Random& random) {
  struct Walked {
    SpaceRay ray;
    std::size_t cells;
    bool is_stopped;
    Operations operations;
  };
  std::vector<Walked> all;
  for (int i = 0; i < 30; ++i) {
    const SpaceRay ray = any_ray(random, shapes.box());
    LimitedVisitor looker(1 + random.below(8));
    software::Counting count;
    directory.walk(ray, looker, count);
    all.push_back({ray, looker.cells, looker.is_stopped(), count.done()});
  }
  // Trees of boxes are complete after all rays.
  const testing::WalkRecount recount(name, shapes, bucket_size, directory);
  std::size_t cells = 0;
  for (const Walked& one : all) {
    testing::check_same(one.operations, recount.along(one.ray, one.cells, one.is_stopped));
    cells += one.cells;
  }
  return cells;
}

}  // namespace

TEST_CASE("directories count as a plain recount of facets and cells does") {
  std::uint64_t scenes = 0;
  std::uint64_t splits = 0;
  std::uint64_t cells = 0;
  for (std::uint64_t seed = 1; scenes < 80; ++seed) {
    const std::optional<testing::Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    ++scenes;
    const software::Facets facets = software::facets_of(scene->tree, scene->geometry);
    const software::FacetShapes shapes(facets);
    Random random(seed);
    const auto bucket_size = static_cast<std::uint32_t>(2 + random.below(12));
    for (const software::DirectoryRow* const row : software::directories()) {
      CAPTURE(seed);
      const std::string name(row->name);
      CAPTURE(name);
      const std::unique_ptr<software::Directory> directory = row->make(shapes, {bucket_size});
      cells += check_walks(name, shapes, bucket_size, *directory, random);
      const software::SpaceBuilt built = directory->built();
      check_same(built, testing::recounted_space(name, shapes, bucket_size, *directory));
      splits += built.splits;
    }
  }
  CHECK(splits > 100 * scenes);
  CHECK(cells > 200 * scenes);
}
