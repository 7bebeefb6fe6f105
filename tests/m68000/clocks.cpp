// Clocks that the programs of tests/m68000 take, as docs/processors.md shows them.

#include <fmt/format.h>

#include <array>

#include "tests/m68000/random_tree.h"
#include "tests/m68000/traversal.h"

namespace {

using namespace csgsim::m68000;

constexpr std::uint32_t trees = 200;

struct Named {
  Method method;
  const char* name;
};

constexpr Named methods[] = {
    {Method::standard, "standard"}, {Method::early_out, "early out"}, {Method::status_tree, "status tree"}};
constexpr Written forms[] = {Written::by_hand, Written::compiled_plainly, Written::compiled_optimised};

/// Of a surface on a ray, with its classification: mean over random trees, a node of the tree.
double clocks_a_node(Method method, Written written) {
  double clocks = 0;
  double nodes = 0;
  for (std::uint32_t seed = 0; seed < trees; ++seed) {
    const RandomTree random(seed);
    M68000Traversal traversal(method, written);
    traversal.load(random.tree());
    for (const std::uint16_t primitive : random.flips()) {
      traversal.flip(primitive);
      traversal.evaluate();
    }
    clocks += static_cast<double>(traversal.clocks());
    nodes += static_cast<double>(random.tree().nodes.size() * random.flips().size());
  }
  return clocks / nodes;
}

}  // namespace

int main() {
  fmt::print("| method | by hand | GCC 12, -O0 | factor | GCC 12, -O1 | factor |\n|---|--:|--:|--:|--:|--:|\n");
  for (const Named& one : methods) {
    std::array<double, std::size(forms)> clocks{};
    for (std::size_t form = 0; form < clocks.size(); ++form) clocks[form] = clocks_a_node(one.method, forms[form]);
    fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} | {:.1f} | {:.2f} |\n", one.name, clocks[0], clocks[1],
               clocks[1] / clocks[0], clocks[2], clocks[2] / clocks[0]);
  }
  return 0;
}
