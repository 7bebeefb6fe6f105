#include "host/emit/levels.h"

#include "tests/support/test.h"
#include "tests/unit/csg/list_trees.h"

using namespace csgsim;
using namespace csgsim::testing;

namespace {

ActiveTree tree_of(std::string_view operand) {
  ActiveTree tree;
  tree.operands = {add_text(tree, operand)};
  return tree;
}

}  // namespace

TEST_CASE("products below the levels evaluated by the stack are counted") {
  // A union of a leaf and an intersection of unions of three leaves and of two: 1 + 3 * 2 products.
  const ActiveTree tree = tree_of("+(.*(+(...)+(..)))");
  CHECK(emit::products_below_levels(tree, 0) == 7);
  CHECK(emit::products_below_levels(tree, 1) == 6);
  CHECK(emit::products_below_levels(tree, 2) == 3 + 2);
  CHECK(emit::products_below_levels(tree, 3) == 0);
  CHECK(emit::products_below_levels(tree, emit::all_levels) == 0);
}

TEST_CASE("several operands are intersected in the mask at the first level") {
  ActiveTree tree = tree_of("+(.*(..))");
  std::string_view second = "+(...)";
  tree.operands.push_back(add_text(tree, second));
  CHECK(emit::products_below_levels(tree, 0) == 2 * 3);
  CHECK(emit::products_below_levels(tree, 1) == 2 + 3);
  CHECK(emit::products_below_levels(tree, 2) == 1);
  CHECK(emit::products_below_levels(tree, 3) == 0);
}
