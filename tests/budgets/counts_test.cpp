#include "hw/isa/facts.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/clocks.h"
#include "tests/budgets/measure.h"
#include "tests/support/test.h"

using namespace csgsim;

// Every count is checked against a sum by hand of the clocks in docs/instruction-set.md: one for an instruction on the
// enable register, the width of a linear expression for each time it is streamed, the width of a field for one source,
// twice that for two sources.

namespace {

constexpr std::uint64_t enable = 1;

constexpr std::uint64_t edge_bits = 21;       // 12 for a coefficient, 9 for a coordinate of 0 to 511
constexpr std::uint64_t depth_bits = 33;      // 20 for depth, 12 for fraction, a sign
constexpr std::uint64_t component_bits = 19;  // 8 for a component, 10 for fraction, a sign

constexpr std::uint64_t triangle = enable + 3 * edge_bits + 2 * depth_bits + 3 * component_bits;
constexpr std::uint64_t shadow = enable + (1 + 3) * depth_bits + 2 * enable;

/// Clocks of adding to a field: enable from one bit, xor the other, propagate the carry, invert the sum. The last bit
/// propagates no carry, and an addend bit of 0 needs no xor.
constexpr std::uint64_t sum(std::uint64_t bits, std::uint64_t of_addend) { return 4 * bits - 1 - (bits - of_addend); }

constexpr std::uint64_t circle_bits = 20;
constexpr std::uint64_t sphere_depth = 15;
constexpr std::uint64_t component = 8;

/// Clocks of shifting the sum up by a bit under the circle's enable, clearing the carry below it, and adding Q again.
constexpr std::uint64_t sum_again(std::uint64_t bits) { return enable + bits + 1 + sum(bits, bits); }

/// Clocks of a sphere, given the widths of its linear expressions for depth and for components, and the number of bits
/// of its depth that overlap the quadratic field.
constexpr std::uint64_t sphere(std::uint64_t depth_expression, std::uint64_t of_addend, std::uint64_t expression = 18,
                               bool twice = false) {
  const std::uint64_t clear_carry = 1;
  const std::uint64_t circle = enable + circle_bits + enable;
  const std::uint64_t depth =
      clear_carry + depth_expression + sum(sphere_depth, of_addend) + (twice ? sum_again(sphere_depth) : 0);
  const std::uint64_t merge = enable + 2 * sphere_depth + sphere_depth + enable;
  const std::uint64_t shade = enable + clear_carry + expression + sum(component, component) +
                              (twice ? sum_again(component) : 0) + enable + component;
  return circle + depth + merge + 3 * shade;
}

/// Clocks of a primitive's instructions, computed from the instruction table.
std::uint64_t listed(const isa::Program& program, std::uint32_t primitive) {
  const machines::Machine machine = kinds::load("pixel-planes-4");
  std::uint64_t total = 0;
  for (const isa::Instruction& instruction : program.segments.at(0).instructions) {
    if (instruction.origin.primitive == primitive) total += machines::clocks(instruction, machine);
  }
  return total;
}

void check(const std::string& name, const std::vector<std::uint64_t>& by_hand) {
  const isa::Program program = isa::load_program(budgets::source_path(name));
  const observe::Stats stats = budgets::measure(program).stats;
  REQUIRE(program.facts->primitives.size() == by_hand.size());
  for (std::uint32_t i = 0; i < by_hand.size(); ++i) {
    CAPTURE(program.facts->primitives[i]);
    CHECK(stats.by_primitive[i].clocks == by_hand[i]);
    CHECK(listed(program, i) == by_hand[i]);
  }
}

}  // namespace

TEST_CASE("a smooth-shaded Z-buffered triangle takes 187 clocks") {
  static_assert(triangle == 187);
  check("triangle.csgt", {triangle, triangle, triangle});
}

TEST_CASE("the shadow of a triangle takes 135 more clocks") {
  static_assert(shadow == 135);
  check("shadow.csgt", {triangle + shadow, triangle + shadow, triangle + shadow});
}

TEST_CASE("a sphere takes 326 or 327 clocks for its outline and depth and colour channels") {
  static_assert(sphere(18, 15) == 327 && sphere(18, 14) == 326 && sphere(19, 13) == 326);
  check("sphere.csgt", {sphere(18, 15), sphere(18, 14), sphere(18, 14), sphere(19, 13)});
}

TEST_CASE("a sphere takes 537 clocks if its radius is not a power of two") {
  static_assert(sphere(21, 14, 21, true) == 537);
  check("sphere_radius.csgt", {sphere(21, 14, 21, true)});
}

TEST_CASE("the Programs of the budgets fit the published 512 x 512 pixels of 72 bits") {
  for (const char* const name : {"triangle.csgt", "shadow.csgt", "sphere.csgt", "sphere_radius.csgt"})
    CHECK((isa::load_program(budgets::source_path(name)).shape == isa::ArrayShape{512, 512, 72}));
}
