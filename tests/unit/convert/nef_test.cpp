#include "tests/unit/convert/nef.h"

#include "host/read/read.h"
#include "places.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;

namespace {

void check_volume(const model::Tree& tree) {
  const double nef = testing::nef_volume(tree);
  const double ours = testing::volume_of(testing::judged(testing::converted(tree)));
  CHECK(ours == doctest::Approx(nef).epsilon(1e-9));
}

}  // namespace

TEST_CASE("volumes of models match CGAL's Nef polyhedra in rational arithmetic") {
  for (const char* const name : {"thesis_fig_2_3", "old_example002", "old_example003"}) {
    CAPTURE(name);
    check_volume(read::read_csg_file(CSGSIM_SOURCE_DIR "/tests/models/" + std::string(name) + ".csg"));
  }
}

TEST_CASE("volumes of random models match CGAL's Nef polyhedra") {
  int full = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const model::Tree tree = read::read_csg_text(testing::random_model(seed, 4), "random.csg");
    if (tree.root == model::no_index) continue;
    check_volume(tree);
    if (testing::nef_volume(tree) > 0.1) ++full;
  }
  CHECK(full > 3);
}
