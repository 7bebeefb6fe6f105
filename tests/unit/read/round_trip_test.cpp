#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/read/random_model.h"
#include "tests/unit/read/support.h"
#include "tests/unit/read/tree_invariants.h"

using namespace csgsim::read_test;
using csgsim::read_test::read;

TEST_CASE("random models survive a round trip in two printing styles") {
  CHECK(rc::check([] {
    const RandomModel model = random_model();
    const std::string meaning = dump(expected_tree(model));
    const std::string named = print_named(model);
    const std::string packed = print_packed(model);
    RC_LOG() << named << '\n' << packed << '\n';
    const csgsim::model::Tree tree = read(named);
    RC_ASSERT(broken_invariant(tree) == "");
    RC_ASSERT(dump(tree) == meaning);
    RC_ASSERT(dump(read(packed)) == meaning);
  }));
}
