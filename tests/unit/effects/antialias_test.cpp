#include "host/effects/antialias.h"

#include <glm/vec2.hpp>

#include "hw/isa/colour_format.h"
#include "hw/machines/clocks.h"
#include "hw/scan_line/kind.h"
#include "sim/functional/clocks.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

using Levels = std::array<int, 3>;

Levels levels_of(std::uint32_t colour) {
  return {static_cast<int>(colour >> 16U), static_cast<int>(colour >> 8U & 255U), static_cast<int>(colour & 255U)};
}

int difference(const Levels& a, const Levels& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

std::string antialias_section(std::size_t samples, const std::string& more = "") {
  return fmt::format("[effects.antialias]\nsamples = {}\n{}", samples, more);
}

testing::Setup random_view(view::Projection projection, const std::string& scene) {
  testing::Setup setup = testing::front_view(61, 47, testing::scene_of(scene));
  setup.camera = {{40, -90, 35}, {0, 0, 0}, projection};
  setup.memory_bits = 300;
  return setup;
}

/// Draws without the effect, sampled at an offset from the pixel centres.
observe::Frame sampled_at(const std::string& csg, testing::Setup setup, const glm::dvec2& offset) {
  setup.options.scene = testing::scene_of("");
  setup.sampling.offset = offset;
  return testing::draw(testing::compile_text(csg, setup).program);
}

std::vector<observe::Frame> sampled(const std::string& csg, const testing::Setup& setup, std::size_t count) {
  std::vector<observe::Frame> frames;
  for (const glm::dvec2& offset : effects::sample_offsets(count)) frames.push_back(sampled_at(csg, setup, offset));
  return frames;
}

/// Sum of a range of the samples at a pixel.
Levels sum_of(const std::vector<observe::Frame>& frames, std::size_t begin, std::size_t end, std::size_t pixel) {
  Levels sum{};
  for (std::size_t i = begin; i < end; ++i) {
    const Levels one = levels_of(frames[i].colour[pixel]);
    for (std::size_t c = 0; c < sum.size(); ++c) sum.at(c) += one.at(c);
  }
  return sum;
}

/// The mean, rounded half up.
Levels mean_of(const std::vector<observe::Frame>& frames, std::size_t count, std::size_t pixel) {
  Levels mean = sum_of(frames, 0, count, pixel);
  for (int& one : mean) one = (one + static_cast<int>(count) / 2) / static_cast<int>(count);
  return mean;
}

/// Adaptive anti-aliasing according to its definition.
Levels refined(const std::vector<observe::Frame>& frames, int min_difference, std::size_t pixel) {
  std::size_t count = std::max<std::size_t>(2, frames.size() / 4);
  while (count < frames.size()) {
    const int enough = min_difference * static_cast<int>(count / 2);
    if (difference(sum_of(frames, 0, count / 2, pixel), sum_of(frames, count / 2, count, pixel)) < enough) break;
    count *= 2;
  }
  return mean_of(frames, count, pixel);
}

/// Largest error with which the first `few` samples estimate the share of all samples on one side of a straight line.
double max_error_at_line(std::size_t few, std::size_t all) {
  const std::vector<glm::dvec2> offsets = effects::sample_offsets(all);
  double worst = 0;
  for (int step = 0; step < 3600; ++step) {
    // Avoids the directions in which samples are collinear.
    const double turn = (step + 0.0123) * std::numbers::pi / 1800;
    std::vector<std::pair<double, bool>> along;
    for (std::size_t i = 0; i < all; ++i)
      along.emplace_back(offsets[i].x * std::cos(turn) + offsets[i].y * std::sin(turn), i < few);
    std::sort(along.begin(), along.end());
    double of_few = 0;
    for (std::size_t i = 0; i < all; ++i) {
      if (along[i].second) of_few += 1.0 / static_cast<double>(few);
      worst = std::max(worst, std::abs(of_few - static_cast<double>(i + 1) / static_cast<double>(all)));
    }
  }
  return worst;
}

const std::string ball_and_hole =
    "color([1,0.2,0.1,1]){difference(){sphere($fn=30,r=9);cylinder($fn=30,h=30,r1=4,r2=2,center=true);}}"
    "color([0.1,0.4,1,1]){cube(size=[25,3,4],center=true);}";

}  // namespace

TEST_CASE("each column and row of a pixel has one sample of anti-aliasing") {
  for (const std::size_t count : {2U, 4U, 8U, 16U}) {
    std::set<double> columns;
    std::set<double> rows;
    const std::vector<glm::dvec2> offsets = effects::sample_offsets(count);
    CHECK(offsets.size() == count);
    CHECK(offsets.front() == glm::dvec2(0));
    for (const glm::dvec2& one : offsets) {
      CHECK(one.x >= -0.5);
      CHECK(one.x < 0.5);
      CHECK(one.y >= -0.5);
      CHECK(one.y < 0.5);
      columns.insert(std::floor(one.x * static_cast<double>(count)));
      rows.insert(std::floor(one.y * static_cast<double>(count)));
    }
    CHECK(columns.size() == count);
    CHECK(rows.size() == count);
  }
}

TEST_CASE("sampling at an offset changes only the constants of the planes") {
  for (const view::Projection projection : {view::Projection::orthographic, view::Projection::perspective}) {
    testing::Setup setup = random_view(projection, "");
    const testing::Compiled centre = testing::compile_text(ball_and_hole, setup);
    setup.sampling.offset = {0.25, -0.375};
    const testing::Compiled aside = testing::compile_text(ball_and_hole, setup);
    REQUIRE(centre.view.planes.size() == aside.view.planes.size());
    CHECK(centre.view.depth.near == aside.view.depth.near);
    CHECK(centre.view.depth.far == aside.view.depth.far);
    for (std::size_t i = 0; i < centre.view.planes.size(); ++i) {
      const view::ScreenPlane& before = centre.view.planes[i];
      const view::ScreenPlane& after = aside.view.planes[i];
      CHECK(before.linear.a == after.linear.a);
      CHECK(before.linear.b == after.linear.b);
      CHECK(before.positive == after.positive);
      // Both constants were rounded from the same real plane.
      const unsigned bits = before.kind == view::PlaneKind::edge ? view::edge_fraction_bits(setup.sampling)
                                                                 : setup.sampling.fraction_bits;
      const double moved = std::ldexp(before.real.a * 0.25 - before.real.b * 0.375, static_cast<int>(bits));
      CHECK(std::abs(static_cast<double>(after.linear.c - before.linear.c) - moved) <= 1.0 + 1e-6 * std::abs(moved));
    }
  }
}

TEST_CASE("the anti-aliased picture is the rounded mean of its samples' pictures") {
  int with_edges = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const std::string csg = testing::random_model(seed, 7);
    const auto projection = seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective;
    const std::size_t count = std::size_t{2} << (seed % 4);
    CAPTURE(seed);
    const testing::Setup setup = random_view(projection, antialias_section(count));
    const observe::Frame picture = testing::draw(testing::compile_text(csg, setup).program);
    const std::vector<observe::Frame> frames = sampled(csg, setup, count);
    CHECK(picture.depth == frames.front().depth);
    int wrong = 0;
    bool has_edges = false;
    for (std::size_t i = 0; i < picture.colour.size(); ++i) {
      wrong += levels_of(picture.colour[i]) != mean_of(frames, count, i);
      has_edges = has_edges || picture.colour[i] != frames.front().colour[i];
    }
    CHECK(wrong == 0);
    with_edges += has_edges;
  }
  // Some models are empty.
  CHECK(with_edges >= 9);
}

TEST_CASE("anti-aliasing with other effects is the mean of their pictures") {
  const std::string others =
      "[effects.smooth]\n[effects.depth_cue]\nbits = 3\n[[effects.textures]]\nsize = 3\nof_colour = [0.1, 0.4, 1]\n"
      "[[materials]]\nof_colour = [1, 0.2, 0.1]\nopacity = 0.5\n";
  for (const view::Projection projection : {view::Projection::orthographic, view::Projection::perspective}) {
    const testing::Setup setup = random_view(projection, antialias_section(4) + others);
    const observe::Frame picture = testing::draw(testing::compile_text(ball_and_hole, setup).program);
    std::vector<observe::Frame> frames;
    for (const glm::dvec2& offset : effects::sample_offsets(4)) {
      testing::Setup one = random_view(projection, others);
      one.sampling.offset = offset;
      frames.push_back(testing::draw(testing::compile_text(ball_and_hole, one).program));
    }
    const testing::Setup fewer = random_view(projection, antialias_section(4, "adaptive = true\n") + others);
    const observe::Frame adaptive = testing::draw(testing::compile_text(ball_and_hole, fewer).program);
    int wrong = 0;
    int wrong_adaptive = 0;
    for (std::size_t i = 0; i < picture.colour.size(); ++i) {
      wrong += levels_of(picture.colour[i]) != mean_of(frames, 4, i);
      wrong_adaptive += levels_of(adaptive.colour[i]) != refined(frames, 1, i);
    }
    CHECK(wrong == 0);
    CHECK(wrong_adaptive == 0);
  }
}

TEST_CASE("anti-aliasing averages each channel separately with fewer colour bits") {
  testing::Setup setup = random_view(view::Projection::orthographic, antialias_section(4));
  setup.options.colour_bits = 11;
  const observe::Frame picture = testing::draw(testing::compile_text(ball_and_hole, setup).program);
  const std::vector<observe::Frame> frames = sampled(ball_and_hole, setup, 4);
  int wrong = 0;
  for (std::size_t i = 0; i < picture.colour.size(); ++i) {
    std::uint32_t expected = 0;
    unsigned from = 11;
    for (const unsigned width : isa::channel_widths(11)) {
      from -= width;
      std::uint32_t sum = 2;
      for (const observe::Frame& one : frames) sum += one.colour[i] >> from & ((1U << width) - 1);
      expected |= (sum / 4) << from;
    }
    wrong += picture.colour[i] != expected;
  }
  CHECK(wrong == 0);
}

TEST_CASE("anti-aliased colours are the means of rays through the same points") {
  for (std::uint64_t seed = 20; seed < 26; ++seed) {
    const std::string csg = testing::random_model(seed, 5);
    const auto projection = seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective;
    CAPTURE(seed);
    const testing::Setup setup = random_view(projection, antialias_section(4));
    const testing::Compiled compiled = testing::compile_text(csg, setup);
    const observe::Frame picture = testing::draw(compiled.program);
    const testing::RayShot shot{setup.camera, 61, 47, compiled.view.depth.near, effects::sample_offsets(4)};
    const auto seen = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene, shot);
    int certain = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!seen[i].is_certain) continue;
      ++certain;
      const Levels ours = levels_of(picture.colour[i]);
      for (int c = 0; c < 3; ++c)
        wrong += std::abs(ours.at(static_cast<std::size_t>(c)) - seen[i].colour[c] * 255) > 0.5 + 1e-6;
    }
    CHECK(wrong == 0);
    CHECK(certain > static_cast<int>(seen.size()) / 2);
  }
}

TEST_CASE("adaptive anti-aliasing stops per pixel by its definition and keeps depths") {
  for (std::uint64_t seed = 40; seed < 49; ++seed) {
    const std::string csg = testing::random_model(seed, 6);
    const std::size_t count = std::size_t{4} << (seed % 3);
    const int min_difference = std::array{1, 20, 100}.at(seed / 3 % 3);
    CAPTURE(seed);
    const testing::Setup setup =
        random_view(view::Projection::perspective,
                    antialias_section(count, fmt::format("adaptive = true\nleast_difference = {}", min_difference)));
    const observe::Frame picture = testing::draw(testing::compile_text(csg, setup).program);
    const std::vector<observe::Frame> frames = sampled(csg, setup, count);
    CHECK(picture.depth == frames.front().depth);
    int wrong = 0;
    for (std::size_t i = 0; i < picture.colour.size(); ++i)
      wrong += levels_of(picture.colour[i]) != refined(frames, min_difference, i);
    CHECK(wrong == 0);
  }
}

TEST_CASE("adaptive and full anti-aliasing differ at straight edges within a bound") {
  // A rotated white square on black.
  const std::string csg =
      "color([1,1,1,1]){multmatrix([[0.8,0,0.6,30],[0,1,0,0],[-0.6,0,0.8,-24],[0,0,0,1]])"
      "{cube(size=[28,4,28],center=true);}}";
  testing::Setup setup = testing::front_view(60, 48, testing::scene_of(testing::plain_colours + antialias_section(16)));
  const observe::Frame full = testing::draw(testing::compile_text(csg, setup).program);
  setup.options.scene =
      testing::scene_of(testing::plain_colours + antialias_section(16, "adaptive = true\nleast_difference = 112"));
  const observe::Frame adaptive = testing::draw(testing::compile_text(csg, setup).program);
  const double bound = std::max(max_error_at_line(4, 16), max_error_at_line(8, 16)) * 255 + 1;
  CHECK(bound < 100);
  int most = 0;
  for (std::size_t i = 0; i < full.colour.size(); ++i)
    most = std::max(most, difference(levels_of(full.colour[i]), levels_of(adaptive.colour[i])));
  CHECK(most <= bound);
  CHECK(most > 0);
}

TEST_CASE("adaptive anti-aliasing more than halves the carburettor's clocks") {
  testing::Setup setup = testing::front_view(256, 256, testing::scene_of(antialias_section(16)));
  setup.camera = {{220, -255, 135}, {2, 0, 5}, view::Projection::orthographic};
  const testing::Compiled all = testing::compile_file(testing::model_path("carburettor"), setup);
  setup.options.scene = testing::scene_of(antialias_section(16, "adaptive = true\nleast_difference = 104"));
  const testing::Compiled fewer = testing::compile_file(testing::model_path("carburettor"), setup);
  const auto clocks = [](const isa::Program& program) {
    return engine::make_functional_engine(testing::machine_of(program.shape))->run(program, {}).clocks;
  };
  CHECK(2 * clocks(fewer.program) < clocks(all.program));
  const observe::Frame full = testing::draw(all.program);
  const observe::Frame adaptive = testing::draw(fewer.program);
  int most = 0;
  for (std::size_t i = 0; i < full.colour.size(); ++i)
    most = std::max(most, difference(levels_of(full.colour[i]), levels_of(adaptive.colour[i])));
  CHECK(most <= max_error_at_line(4, 16) * 255 + 1);
}

TEST_CASE("adaptive anti-aliasing skips refinement if no pixel needs it") {
  testing::Setup setup = testing::front_view(32, 32, testing::scene_of(antialias_section(4, "adaptive = true")));
  const std::string wall = testing::box_text({-10, 0, -50}, {50, 1, 50});
  const testing::Compiled refined = testing::compile_text(wall, setup);
  const auto run = [](const isa::Program& program) {
    return engine::make_functional_engine(testing::machine_of(program.shape))->run(program, {});
  };
  CHECK(run(refined.program).skipped > 0);
  // An edge in the picture needs refinement.
  CHECK(run(testing::compile_text(testing::box_text({-10, 0, -50}, {9.3, 1, 50}), setup).program).skipped == 0);
}

TEST_CASE("an anti-aliased picture is the same on scan-line as on Pixel-planes") {
  for (const char* adaptive : {"adaptive = false", "adaptive = true"}) {
    testing::Setup setup = random_view(view::Projection::perspective, antialias_section(4, adaptive));
    const observe::Frame whole = testing::draw(testing::compile_text(ball_and_hole, setup).program);
    setup.kind = &scan_line::kind;
    const observe::Frame lines = testing::draw(testing::compile_text(ball_and_hole, setup).program);
    CHECK(whole.colour == lines.colour);
    CHECK(whole.depth == lines.depth);
  }
}

TEST_CASE("anti-aliasing rejects a number of samples that is not a supported power of two") {
  CHECK(testing::error_of([] { testing::scene_of(antialias_section(3)); }).find("use 2, 4, 8 or 16") !=
        std::string::npos);
  CHECK(testing::error_of([] { testing::scene_of(antialias_section(12)); }).find("use 2, 4, 8 or 16") !=
        std::string::npos);
}
