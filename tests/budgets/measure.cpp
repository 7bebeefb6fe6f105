#include "tests/budgets/measure.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "tests/support/test.h"

namespace csgsim::budgets {

std::string source_path(const std::string& name) { return std::string(CSGSIM_SOURCE_DIR) + "/tests/budgets/" + name; }

Measured measure(const isa::Program& program) {
  const machines::Machine machine = kinds::load("pixel-planes-4");
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  REQUIRE(result.overflows == 0);
  return {stats.stats(), frame.frame()};
}

std::uint64_t max_primitive_clocks(const observe::Stats& stats) {
  std::uint64_t most = 0;
  for (const observe::Cost& cost : stats.by_primitive) most = std::max(most, cost.clocks);
  return most;
}

double clocks_per_expression(const observe::Stats& stats) {
  std::uint64_t expressions = 0;
  for (const isa::OpcodeInfo& row : isa::opcode_table) {
    if (isa::has_operand(row.operands, isa::OperandKind::linear))
      expressions += stats.by_opcode.at(static_cast<std::size_t>(row.opcode)).instructions;
  }
  return static_cast<double>(stats.total.clocks) / static_cast<double>(expressions);
}

std::array<double, 3> barycentric_coordinates(const Triangle& triangle, double x, double y) {
  const auto twice_area = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
  const auto& [a, b, c] = triangle;
  const double whole = twice_area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
  const double of_b = twice_area(x - a.x, y - a.y, c.x - a.x, c.y - a.y) / whole;
  const double of_c = twice_area(b.x - a.x, b.y - a.y, x - a.x, y - a.y) / whole;
  return {1 - of_b - of_c, of_b, of_c};
}

double interpolate(const Triangle& triangle, const std::array<double, 3>& values, double x, double y) {
  const std::array<double, 3> of = barycentric_coordinates(triangle, x, y);
  return of[0] * values[0] + of[1] * values[1] + of[2] * values[2];
}

}  // namespace csgsim::budgets
