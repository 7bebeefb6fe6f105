#include "host/csg/tested.h"

#include "host/csg/counted.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr view::FixedLinear plane{3, -2, 7};

}  // namespace

TEST_CASE("Tested reports a test as known after the same plane and rectangle were added") {
  csg::Tested tested;
  CHECK(tested.add(plane, {0, 0, 9, 9}) == csg::ExtremesSource::by_test);
  CHECK(tested.add(plane, {0, 0, 9, 9}) == csg::ExtremesSource::known);
  CHECK(tested.add(plane, {0, 0, 9, 8}) == csg::ExtremesSource::by_test);
  CHECK(tested.add({3, -2, 8}, {0, 0, 9, 9}) == csg::ExtremesSource::by_test);
  tested.seal();
  CHECK(tested.add(plane, {0, 0, 9, 8}) == csg::ExtremesSource::known);
  csg::Tested copy;
  copy.add(tested);
  CHECK(copy.add(plane, {0, 0, 9, 9}) == csg::ExtremesSource::known);
  CHECK(copy.add(plane, {1, 0, 9, 9}) == csg::ExtremesSource::by_test);
}

TEST_CASE("a row takes its extremes from the row above with the same columns") {
  csg::Tested above;
  above.add(plane, {2, 5, 9, 5});
  above.add(plane, {0, 4, 9, 5});
  above.seal();
  csg::Tested row;
  row.follow(above);
  CHECK(row.add(plane, {2, 6, 9, 6}) == csg::ExtremesSource::from_row);
  CHECK(row.add(plane, {3, 6, 9, 6}) == csg::ExtremesSource::by_test);
  CHECK(row.add(plane, {2, 7, 9, 7}) == csg::ExtremesSource::by_test);
  CHECK(row.add(plane, {0, 5, 9, 6}) == csg::ExtremesSource::by_test);
}

TEST_CASE("Counted charges a half-space, two values if from a row, or a box if known") {
  csg::Tested above;
  above.add(plane, {2, 5, 9, 5});
  above.seal();
  csg::Tested tested;
  tested.follow(above);
  isa::Preparation counts;
  const csg::Counted counted(counts, &tested);
  counted.test(plane, {2, 6, 9, 6});
  CHECK(counts == isa::Preparation{.values = 2});
  counted.test(plane, {0, 6, 9, 6});
  CHECK(counts == isa::Preparation{.halfspaces = 1, .values = 2});
  counted.test(plane, {0, 6, 9, 6});
  CHECK(counts == isa::Preparation{.boxes = 1, .halfspaces = 1, .values = 2});
  CHECK(!counted.test_if_new(plane, {0, 6, 9, 6}));
  CHECK(counts == isa::Preparation{.boxes = 1, .halfspaces = 1, .values = 2});
  counted.test_if_new(plane, {0, 7, 9, 7});
  CHECK(counts.halfspaces == 2);
}
