#include <doctest/doctest.h>
#include <fmt/format.h>

#include <fstream>

#include "hw/isa/program_file.h"
#include "tests/budgets/measure.h"
#include "tests/support/drawing.h"

using namespace csgsim;

namespace {

constexpr double published_triangle = 1e7 / 30'000;
constexpr double published_shadow = 1e7 / 21'000;
constexpr double published_sphere = 1e7 / 25'000;
constexpr double published_expression = 7.5e-3 * 1e7 / 1'900;

/// The page's first row that begins with that name, without the name.
std::string row_of_page(const std::string& name) {
  std::ifstream page(std::string(CSGSIM_SOURCE_DIR) + "/docs/budgets.md");
  const std::string begin = "| " + name + " |";
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(begin)) return line.substr(begin.size());
  }
  return "(no such row)";
}

std::string with_commas(std::uint64_t value) {
  return value < 1000 ? fmt::format("{}", value) : fmt::format("{},{:03}", value / 1000, value % 1000);
}

void check_row(const std::string& name, double published, std::uint64_t ours) {
  INFO("if the change is meant: tests/budgets/table.py build/release/csgsim, and docs/budgets.md");
  CHECK(row_of_page(name) ==
        fmt::format(" {:.0f} | {} | {:.2f} |", published, with_commas(ours), static_cast<double>(ours) / published));
}

void check_expressions(const std::string& name, double ours) {
  INFO("if the change is meant: tests/budgets/table.py build/release/csgsim, and docs/budgets.md");
  CHECK(row_of_page("an expression of " + name) ==
        fmt::format(" {:.1f} | {:.1f} | {:.2f} |", published_expression, ours, ours / published_expression));
}

std::uint64_t run(const std::string& name) {
  return budgets::dearest_primitive(budgets::measure(isa::load_program(budgets::place(name))).stats);
}

isa::Program compiled(const std::string& path, const view::Camera& camera) {
  return testing::compile_file(path, {camera, {}, 72}).program;
}

}  // namespace

TEST_CASE("the page of budgets has what the Programs of triangles and spheres take") {
  check_row("triangle", published_triangle, run("triangle.csgt"));
  check_row("triangle with shadow", published_shadow, run("shadow.csgt"));
  check_row("sphere", published_sphere, run("sphere.csgt"));
  check_row("sphere of another radius", published_sphere, run("sphere_radius.csgt"));
}

TEST_CASE("the page of budgets has what spheres of facets take") {
  const view::Camera camera = testing::camera({0, -1286.98, 0}, {0, 0, 0}, view::Projection::orthographic);
  for (const int facets : {16, 32}) {
    const isa::Program program = compiled(budgets::place(fmt::format("sphere_{}.csg", facets)), camera);
    check_row(fmt::format("sphere of {} facets", program.facts.model.halfspaces), published_sphere,
              budgets::dearest_primitive(budgets::measure(program).stats));
  }
}

TEST_CASE("the page of budgets has what a linear expression of the models takes") {
  for (const testing::ThesisObject& object : testing::thesis_objects(view::Projection::orthographic)) {
    if (object.name == "thesis_fig_2_3") continue;
    const isa::Program program = compiled(testing::model_path(object.name), object.camera);
    check_expressions(object.name, budgets::clocks_an_expression(budgets::measure(program).stats));
  }
}
