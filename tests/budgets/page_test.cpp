#include "tests/budgets/page.h"

#include "hw/isa/facts.h"
#include "hw/isa/program_file.h"
#include "tests/budgets/measure.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

void check_expressions(const std::string& name, double ours) {
  INFO("if the change is intended, run tests/budgets/table.py build/release/csgsim and update docs/performance.md");
  CHECK(budgets::row_of_page("an expression of " + name) == fmt::format(" {:.1f} | {:.1f} | {:.2f} |",
                                                                        budgets::published_expression, ours,
                                                                        ours / budgets::published_expression));
}

std::uint64_t run(const std::string& name) {
  return budgets::max_primitive_clocks(budgets::measure(isa::load_program(budgets::source_path(name))).stats);
}

isa::Program compiled(const std::string& path, const view::Camera& camera) {
  return testing::compile_file(path, {camera, {}, 72}).program;
}

}  // namespace

TEST_CASE("docs/performance.md states the measured clocks of triangles and spheres") {
  budgets::check_row("triangle", budgets::published_triangle, run("triangle.csgt"));
  budgets::check_row("triangle with shadow", budgets::published_shadow, run("shadow.csgt"));
  budgets::check_row("sphere", budgets::published_sphere, run("sphere.csgt"));
  budgets::check_row("sphere of another radius", budgets::published_sphere, run("sphere_radius.csgt"));
}

TEST_CASE("docs/performance.md states the measured clocks of faceted spheres") {
  const view::Camera camera = testing::camera({0, -1286.98, 0}, {0, 0, 0}, view::Projection::orthographic);
  for (const int facets : {16, 32}) {
    const isa::Program program = compiled(budgets::source_path(fmt::format("sphere_{}.csg", facets)), camera);
    budgets::check_row(fmt::format("sphere of {} facets", program.facts->model.halfspaces), budgets::published_sphere,
                       budgets::max_primitive_clocks(budgets::measure(program).stats));
  }
}

TEST_CASE("docs/performance.md states the measured clocks of a linear expression") {
  for (const testing::ThesisObject& object : testing::thesis_objects(view::Projection::orthographic)) {
    if (object.name == "thesis_fig_2_3") continue;
    const isa::Program program = compiled(testing::model_path(object.name), object.camera);
    check_expressions(object.name, budgets::clocks_per_expression(budgets::measure(program).stats));
  }
}
