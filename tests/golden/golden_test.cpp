#include <png.h>

#include <nlohmann/json.hpp>

#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "sim/session/model/prices.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string trace(const std::string& name, const std::string& extension) {
  return std::string(CSGSIM_SOURCE_DIR) + "/traces/" + name + extension;
}

std::vector<std::uint32_t> read_picture(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
  std::vector<std::uint32_t> pixels;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    pixels.push_back(static_cast<std::uint32_t>(bytes[i]) << 16U | static_cast<std::uint32_t>(bytes[i + 1]) << 8U |
                     bytes[i + 2]);
  }
  return pixels;
}

void check_run(const std::string& name) {
  const isa::Program program = isa::load_program(trace(name, ".csgt"));
  nlohmann::json golden = nlohmann::json::parse(std::ifstream(trace(name, ".json")));
  machines::Machine machine = kinds::load(golden["machine"]["name"].get<std::string>());
  machines::adopt_shape(machine, program);
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const auto engine = engine::make_functional_engine(machine);
  const engine::RunResult result = engine->run(program, observers);
  nlohmann::json actual =
      nlohmann::json::parse(observe::to_json({program, machine, engine->level(), result, stats.stats(), 0.0}).dump());
  actual.erase("wall_seconds");
  golden.erase("wall_seconds");
  INFO("if the change is intended, run traces/renew.sh build/release/csgsim");
  CHECK(nlohmann::json::diff(golden, actual).dump() == "[]");
  CHECK(frame.frame().colour == read_picture(trace(name, ".png")));
}

/// Compares a compiled model with its trace; only names of files may differ.
void check_compilation(const std::string& name, const std::string& model, const std::string& machine_name,
                       const view::Camera& camera, machines::Size size = {512, 512}) {
  machines::Machine machine = kinds::load(machine_name);
  machines::set_picture_size(machine, size);
  view::Sampling sampling;
  sampling.width = size.width;
  sampling.height = size.height;
  const model::Tree tree = read::read_csg_file(testing::model_path(model));
  const facet::Geometry scene = facet::make_geometry(tree);
  emit::Options options;
  options.prices_on = session::weighed_prices_on;
  isa::Program compiled = emit::compile(tree, scene, view::make_view(scene, tree, camera, sampling), machine, options);
  isa::Program golden = isa::load_program(trace(name, ".csgt"));
  golden.facts->model.file.clear();
  compiled.facts->model.file.clear();
  INFO("if the change is intended, run traces/renew.sh build/release/csgsim");
  REQUIRE(compiled.segments.size() == golden.segments.size());
  for (std::size_t i = 0; i < golden.segments.size(); ++i)
    CHECK(compiled.segments[i].instructions.size() == golden.segments[i].instructions.size());
  CHECK((compiled == golden));
}

constexpr view::Camera to_fig_2_3{{42, -38, 41}, {10, 5.5, 2}, view::Projection::orthographic};
constexpr view::Camera to_drilled_cube{{65, -95, 60}, {0, 0, -2}, view::Projection::orthographic};

}  // namespace

TEST_CASE("the trace of fig. 2.3's object runs to its golden counts and picture") { check_run("thesis_fig_2_3"); }
TEST_CASE("the trace of the carburettor runs to its golden counts and picture") { check_run("carburettor"); }
TEST_CASE("the trace of the terrain vehicle runs to its golden counts and picture") { check_run("terrain_vehicle"); }
TEST_CASE("the trace of a drilled cube runs to its golden counts and picture") { check_run("old_example002"); }

TEST_CASE("the trace of a drilled cube in lines runs to its golden counts and picture") {
  check_run("old_example002_lines");
}
TEST_CASE("the trace of fig. 2.3's object in squares runs to its golden counts and picture") {
  check_run("thesis_fig_2_3_squares");
}

TEST_CASE("the trace of fig. 2.3's object in subsegments runs to its golden results") {
  check_run("thesis_fig_2_3_nodes");
}

TEST_CASE("fig. 2.3's object compiles to its golden trace") {
  check_compilation("thesis_fig_2_3", "thesis_fig_2_3", "pixel-planes-4", to_fig_2_3);
}
TEST_CASE("the carburettor compiles to its golden trace") {
  check_compilation("carburettor", "carburettor", "pixel-planes-4",
                    {{220, -255, 135}, {2, 0, 5}, view::Projection::perspective});
}
TEST_CASE("the terrain vehicle compiles to its golden trace") {
  check_compilation("terrain_vehicle", "terrain_vehicle", "pixel-planes-4",
                    {{560, -590, 420}, {-5, 0, 68}, view::Projection::perspective});
}
TEST_CASE("a drilled cube compiles to its golden trace") {
  check_compilation("old_example002", "old_example002", "pixel-planes-4", to_drilled_cube, {200, 150});
}
TEST_CASE("a drilled cube compiles to its golden trace of lines") {
  check_compilation("old_example002_lines", "old_example002", "scan-line", to_drilled_cube, {100, 75});
}
TEST_CASE("fig. 2.3's object compiles to its golden trace of squares") {
  check_compilation("thesis_fig_2_3_squares", "thesis_fig_2_3", "pixel-square", to_fig_2_3, {150, 100});
}
TEST_CASE("fig. 2.3's object compiles to its golden trace of subsegments") {
  check_compilation("thesis_fig_2_3_nodes", "thesis_fig_2_3", "multi-processor", to_fig_2_3, {96, 64});
}
