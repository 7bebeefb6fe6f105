// Prints the clocks of the programs of tests/m68000, as shown in docs/host.md.

#include <fmt/format.h>

#include "tests/m68000/mean_clocks.h"

namespace {

using namespace csgsim::m68000;

struct Named {
  Method method;
  const char* name;
};

constexpr Named methods[] = {{Method::standard, "standard"},
                             {Method::early_out, "early out"},
                             {Method::positional, "positional coding"},
                             {Method::status_tree, "status tree"},
                             {Method::bit_parallel, "bit-parallel"}};

}  // namespace

int main() {
  fmt::print(
      "| method | by hand | a node | in C, -O0 | factor | in C, -O1 | factor |\n|---|--:|--:|--:|--:|--:|--:|\n");
  for (const Named& one : methods) {
    const MeanClocks by_hand = mean_clocks(one.method, Written::by_hand);
    fmt::print("| {} | {:.0f} | {:.1f} |", one.name, by_hand.clocks / by_hand.surfaces, by_hand.clocks / by_hand.nodes);
    for (const Written form : {Written::compiled_plainly, Written::compiled_optimised}) {
      const MeanClocks compiled = mean_clocks(one.method, form);
      fmt::print(" {:.0f} | {:.2f} |", compiled.clocks / compiled.surfaces, compiled.clocks / by_hand.clocks);
    }
    fmt::print("\n");
  }
  return 0;
}
