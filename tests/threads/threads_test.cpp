#include "host/read/read.h"
#include "hw/base/output_file.h"
#include "hw/base/work.h"
#include "hw/kinds/load.h"
#include "places.h"
#include "sim/engine/engine.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/formats.h"
#include "sim/software/convert/surface.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/parallel.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

struct Run {
  observe::Frame frame;
  engine::RunResult result;
};

Run run(const isa::Program& program, unsigned threads) {
  observe::FrameObserver observer(program);
  const std::array<engine::Observer*, 1> observers{&observer};
  const auto engine = engine::make_functional_engine(testing::machine_of(program.shape), threads);
  engine::RunResult result = engine->run(program, observers);
  return {observer.frame(), std::move(result)};
}

isa::Program carburettor(emit::Strategy strategy) {
  testing::Setup setup;
  setup.sampling.width = 180;
  setup.sampling.height = 130;
  setup.memory_bits = 128;
  setup.options.strategy = strategy;
  return testing::compile_default_view(testing::model_path("carburettor"), setup, view::Projection::perspective)
      .program;
}

/// A point and the job that draws it.
struct Drawn {
  studies::DesignPoint point;
  studies::Job job;
};

/// One model under every strategy with several depths: all jobs share the model.
std::vector<Drawn> drawn_points() {
  model::Tree tree = read::read_csg_file(testing::model_path("thesis_fig_2_3"));
  facet::Geometry scene = facet::make_geometry(tree);
  const view::Camera camera = view::default_camera(scene.box, 40, 33);
  const auto subject = std::make_shared<studies::Subject>(studies::Subject{std::move(tree), std::move(scene), "hash"});
  std::vector<Drawn> all;
  for (const emit::Strategy strategy : {emit::Strategy::stack, emit::Strategy::list, emit::Strategy::products}) {
    for (const unsigned z_bits : {12U, 14U, 16U, 18U}) {
      Drawn one{{}, {subject, camera, {}, kinds::load("pixel-planes-4"), {}, {}}};
      one.point.strategy = emit::name_of(strategy);
      one.point.z_bits = z_bits;
      one.job.machine.array = {40, 33, 128};
      one.job.sampling.width = 40;
      one.job.sampling.height = 33;
      one.job.sampling.z_bits = z_bits;
      one.job.options.strategy = strategy;
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// Measures all points on four threads, with or without drawing.
template <class Finished>
void measure_all(const std::vector<Drawn>& all, bool is_drawn, const Finished& finished) {
  studies::measure_each(
      all.size(), 4,
      [&](std::size_t i) { return studies::SweepRow(measure_picture(all[i].point, all[i].job, is_drawn)); }, finished);
}

}  // namespace

TEST_CASE("picture and counts of several tiles are equal for any number of threads") {
  for (const emit::Strategy strategy : {emit::Strategy::stack, emit::Strategy::list}) {
    const isa::Program program = carburettor(strategy);
    const Run one = run(program, 1);
    CHECK(one.result.skipped > 0);
    for (const unsigned threads : {2U, 3U, 8U}) {
      const Run several = run(program, threads);
      CHECK(several.frame.colour == one.frame.colour);
      CHECK(several.frame.depth == one.frame.depth);
      CHECK(several.frame.owner == one.frame.owner);
      CHECK(several.result.clocks == one.result.clocks);
      CHECK(several.result.skipped == one.result.skipped);
      CHECK(several.result.work == one.result.work);
    }
  }
}

TEST_CASE("points of one model measured on four threads equal those measured on one") {
  const std::vector<Drawn> all = drawn_points();
  std::vector<studies::SweepRow> rows;
  measure_all(all, true, [&](studies::SweepRow row) { rows.push_back(std::move(row)); });
  REQUIRE(rows.size() == all.size());
  for (const Drawn& one : all) {
    const studies::SweepRow alone(measure_picture(one.point, one.job, true));
    CHECK(alone.is_compiled());
    CHECK(std::ranges::count(rows, alone) == 1);
  }
}

TEST_CASE("a receiver's exception is rethrown once and nothing is received after it") {
  std::size_t received = 0;
  const auto fails_at_the_third = [&](const studies::SweepRow& /*row*/) {
    if (++received == 3) throw std::runtime_error("the disk is full");
  };
  CHECK_THROWS_WITH_AS(measure_all(drawn_points(), false, fails_at_the_third), "the disk is full", std::runtime_error);
  CHECK(received == 3);
}

TEST_CASE("a mesh and the error for too much work are equal for any number of threads") {
  namespace convert = software::convert;
  for (const char* const name : {"corpus/thread", "corpus/mesh_booleans", "models/carburettor"}) {
    CAPTURE(name);
    const model::Tree tree = read::read_csg_file(std::string(CSGSIM_SOURCE_DIR "/tests/") + name + ".csg");
    const auto stl = [&](unsigned threads, const Work& work) {
      return convert::format_of(".stl")->write(convert::make_surface(convert::boundary(tree, {}, work, threads)), {});
    };
    const Work counted(1'000'000'000);
    const std::string alone = stl(1, counted);
    for (const unsigned threads : {2U, 3U, 8U}) {
      CAPTURE(threads);
      CHECK(stl(threads, {}) == alone);
      CHECK_NOTHROW(stl(threads, Work(counted.done())));
      CHECK_THROWS_AS(stl(threads, Work(counted.done() - 1)), WorkError);
    }
  }
}
