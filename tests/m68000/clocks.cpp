// Clocks that the programs of tests/m68000 take, as docs/processors.md shows them.

#include <fmt/format.h>

#include "tests/m68000/developed_tree.h"
#include "tests/m68000/random_tree.h"
#include "tests/m68000/traversal.h"

namespace {

using namespace csgsim::m68000;

constexpr std::uint32_t seeds = 400;
constexpr std::size_t most_primitives = 20;

struct Named {
  Method method;
  const char* name;
};

constexpr Named methods[] = {{Method::standard, "standard"},
                             {Method::early_out, "early out"},
                             {Method::positional, "positional coding"},
                             {Method::status_tree, "status tree"},
                             {Method::bit_parallel, "bit-parallel"}};

struct Sum {
  double clocks = 0;
  double surfaces = 0;  ///< through each the ray goes, and the point there is classified
  double nodes = 0;     ///< of the tree, at each of them
};

/// Over random trees of as many levels as bits of a long have room for.
Sum sum_of(Method method, Written written) {
  Sum sum;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const RandomTree random(seed, most_primitives);
    if (levels_of(random.tree()) > most_levels) continue;
    M68000Traversal traversal(method, written);
    traversal.load(random.tree());
    for (const std::uint16_t primitive : random.flips()) {
      traversal.flip(primitive);
      traversal.evaluate();
    }
    sum.clocks += static_cast<double>(traversal.clocks());
    sum.surfaces += static_cast<double>(random.flips().size());
    sum.nodes += static_cast<double>(random.flips().size() * random.tree().nodes.size());
  }
  return sum;
}

}  // namespace

int main() {
  fmt::print(
      "| method | by hand | a node | in C, -O0 | factor | in C, -O1 | factor |\n|---|--:|--:|--:|--:|--:|--:|\n");
  for (const Named& one : methods) {
    const Sum by_hand = sum_of(one.method, Written::by_hand);
    fmt::print("| {} | {:.0f} | {:.1f} |", one.name, by_hand.clocks / by_hand.surfaces, by_hand.clocks / by_hand.nodes);
    for (const Written form : {Written::compiled_plainly, Written::compiled_optimised}) {
      const Sum compiled = sum_of(one.method, form);
      fmt::print(" {:.0f} | {:.2f} |", compiled.clocks / compiled.surfaces, compiled.clocks / by_hand.clocks);
    }
    fmt::print("\n");
  }
  return 0;
}
