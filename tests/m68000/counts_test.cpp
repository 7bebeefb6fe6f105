#include "sim/software/methods/counts.h"

#include <rapidcheck.h>

#include "hw/processors/processor.h"
#include "sim/software/traversals/bit_parallel.h"
#include "sim/software/traversals/early_out.h"
#include "sim/software/traversals/positional.h"
#include "sim/software/traversals/standard.h"
#include "sim/software/traversals/status.h"
#include "sim/software/tree/builder.h"
#include "tests/m68000/developed_tree.h"
#include "tests/m68000/random_tree.h"
#include "tests/m68000/traversal.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Tolerance of counted and priced clocks, relative to those of the assembly: the programmer could use addressing modes
/// and condition flags, whereas counts distinguish only kinds of operations.
constexpr double most_off = 0.2;

model::Operator operator_of(m68000::NodeKind kind) {
  switch (kind) {
    case m68000::NodeKind::set_union: return model::Operator::unite;
    case m68000::NodeKind::difference: return model::Operator::subtract;
    case m68000::NodeKind::intersection:
    case m68000::NodeKind::primitive: break;
  }
  return model::Operator::intersect;
}

software::Tree as_counted(const m68000::RandomTree& random) {
  software::Builder builder(random.primitives());
  for (const m68000::TreeNode& node : random.tree().nodes) {
    if (node.kind == m68000::NodeKind::primitive) {
      builder.leaf(node.primitive);
    } else {
      builder.join(operator_of(node.kind), static_cast<std::uint32_t>(node.left),
                   static_cast<std::uint32_t>(node.right));
    }
  }
  return builder.take_tree(static_cast<std::uint32_t>(random.tree().root));
}

/// Clocks of a tree's flips and evaluations: counted and priced, and those of the assembly.
struct Clocks {
  double counted = 0;
  double assembly = 0;
};

/// Evaluates the tree after each flip in both ways.
template <template <class> class Traversal>
Clocks clocks_of(const m68000::RandomTree& random, m68000::Method method) {
  const processors::Processor processor = processors::load_processor("mc68000+compiler.factor=1000");
  const software::Tree tree = as_counted(random);
  software::CountingMethod count;
  Traversal<software::CountingMethod> traversal(tree);
  m68000::M68000Traversal judge(method);
  judge.load(random.tree());
  for (const std::uint16_t primitive : random.flips()) {
    traversal.flip(primitive, count);
    judge.flip(primitive);
    RC_ASSERT(traversal.evaluate(count) == judge.evaluate());
  }
  return {processors::clocks(count.done(), processor), static_cast<double>(judge.clocks())};
}

template <template <class> class Traversal>
void check_clocks(m68000::Method method) {
  double least = 1;
  double most = 1;
  CHECK(rc::check([&](std::uint32_t seed) {
    const m68000::RandomTree random(seed);
    if (random.primitives() < 2) return;
    if (method == m68000::Method::bit_parallel && m68000::levels_of(random.tree()) > m68000::most_levels) return;
    const Clocks clocks = clocks_of<Traversal>(random, method);
    const double ratio = clocks.counted / clocks.assembly;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
    RC_ASSERT(ratio > 1 - most_off);
    RC_ASSERT(ratio < 1 + most_off);
  }));
  MESSAGE(fmt::format("counted clocks are {:.3f} to {:.3f} of the assembly's", least, most));
}

}  // namespace

TEST_CASE("counted clocks of the standard traversal are 0.8 to 1.2 times its assembly's") {
  check_clocks<software::Standard>(m68000::Method::standard);
}

TEST_CASE("counted clocks of early out are 0.8 to 1.2 times its assembly's") {
  check_clocks<software::EarlyOut>(m68000::Method::early_out);
}

TEST_CASE("counted clocks of the status tree are 0.8 to 1.2 times its assembly's") {
  check_clocks<software::StatusTree>(m68000::Method::status_tree);
}

TEST_CASE("counted clocks of positional coding are 0.8 to 1.2 times its assembly's") {
  check_clocks<software::Positional>(m68000::Method::positional);
}

TEST_CASE("counted clocks of the bit-parallel method are 0.8 to 1.2 times its assembly's") {
  check_clocks<software::BitParallel>(m68000::Method::bit_parallel);
}
