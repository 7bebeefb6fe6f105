#include "host/effects/antialias.h"
#include "hw/scan_line/kind.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 53;
constexpr std::uint32_t height = 43;

testing::Setup random_view(view::Projection projection, const std::string& scene) {
  testing::Setup setup = testing::front_view(width, height, testing::scene_of(scene));
  setup.camera = {{40, -90, 35}, {0, 0, 0}, projection};
  setup.memory_bits = 300;
  return setup;
}

/// Rows of a picture as text: whether each pixel has the colour.
std::vector<std::string> rows_with_colour(const observe::Frame& frame, std::uint32_t colour) {
  std::vector<std::string> rows;
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    rows.emplace_back();
    for (std::uint32_t x = 0; x < frame.width; ++x)
      rows.back() += frame.colour[y * frame.width + x] == colour ? '#' : '.';
  }
  return rows;
}

const std::string red_lines = "[effects.edges]\ncolour = [1, 0, 0]\n";
constexpr std::uint32_t red = 0xff0000;

}  // namespace

TEST_CASE("an edge line is drawn where the pixel to the right or below shows another facet") {
  // The view is along +y, so one face of each box is visible.
  const std::string boxes = testing::box_text({1, 0, -5}, {5, 1, -2}) + testing::box_text({5, 0, -4}, {7, 1, -3});
  const testing::Setup setup = testing::front_view(9, 7, testing::scene_of(testing::plain_colours + red_lines));
  const observe::Frame frame = testing::draw(testing::compile_text(boxes, setup).program);
  CHECK(rows_with_colour(frame, red) == std::vector<std::string>{
                                            ".........",
                                            ".####....",
                                            "#...###..",
                                            "#...###..",
                                            "#####....",
                                            ".........",
                                            ".........",
                                        });
}

TEST_CASE("edge lines are exactly where neighbouring rays hit different facets") {
  int lines = 0;
  int plain = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const std::string csg = testing::random_model(seed, 6);
    const auto projection = seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective;
    const bool of_primitives = seed % 4 >= 2;
    CAPTURE(seed);
    const std::string scene = red_lines + (of_primitives ? "between = \"primitives\"\n" : "crease = 0\n");
    const testing::Setup setup = random_view(projection, scene);
    const testing::Compiled compiled = testing::compile_text(csg, setup);
    const observe::Frame picture = testing::draw(compiled.program);
    const testing::RayShot shot{setup.camera, width, height, compiled.view.depth.near};
    const auto seen = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene, shot);
    const auto differ = [&](std::size_t a, std::size_t b) {
      if (seen[a].primitive != seen[b].primitive) return true;
      return !of_primitives && seen[a].halfspace != seen[b].halfspace;
    };
    int wrong = 0;
    for (std::size_t y = 0; y + 1 < height; ++y) {
      for (std::size_t x = 0; x + 1 < width; ++x) {
        const std::size_t i = y * width + x;
        if (!seen[i].is_certain || !seen[i + 1].is_certain || !seen[i + width].is_certain) continue;
        const bool expected = differ(i, i + 1) || differ(i, i + width);
        wrong += expected != (picture.colour[i] == red);
        (expected ? lines : plain) += 1;
      }
    }
    CHECK(wrong == 0);
  }
  CHECK(lines > 200);
  CHECK(plain > 2000);
}

TEST_CASE("facets that meet at less than the crease angle have no edge line between them") {
  const auto lines = [](int fragments, const std::string& more) {
    const testing::Setup setup = random_view(view::Projection::orthographic, red_lines + more);
    const std::string csg = fmt::format("cylinder($fn={},h=20,r1=12,r2=12,center=true);", fragments);
    const observe::Frame frame = testing::draw(testing::compile_text(csg, setup).program);
    // A row that crosses only the side.
    return rows_with_colour(frame, red).at(26);
  };
  const auto count = [](const std::string& row) { return std::count(row.begin(), row.end(), '#'); };
  CHECK(count(lines(24, "")) == 2);
  CHECK(count(lines(6, "")) > 2);
  CHECK(count(lines(24, "crease = 10\n")) > 6);
}

TEST_CASE("edge lines leave depths and all other colours unchanged") {
  const std::string csg = testing::random_model(3, 6);
  const observe::Frame plain =
      testing::draw(testing::compile_text(csg, random_view(view::Projection::perspective, "")).program);
  const observe::Frame lined =
      testing::draw(testing::compile_text(csg, random_view(view::Projection::perspective, red_lines)).program);
  CHECK(plain.depth == lined.depth);
  int other = 0;
  for (std::size_t i = 0; i < plain.colour.size(); ++i)
    other += lined.colour[i] != plain.colour[i] && lined.colour[i] != red;
  CHECK(other == 0);
}

TEST_CASE("anti-aliased edge lines are the means of the lines in each sample") {
  const std::string csg = testing::random_model(5, 6);
  const testing::Setup setup =
      random_view(view::Projection::orthographic, red_lines + "[effects.antialias]\nsamples = 4\n");
  const observe::Frame picture = testing::draw(testing::compile_text(csg, setup).program);
  std::vector<observe::Frame> frames;
  for (const glm::dvec2& offset : effects::sample_offsets(4)) {
    testing::Setup one = random_view(view::Projection::orthographic, red_lines);
    one.sampling.offset = offset;
    frames.push_back(testing::draw(testing::compile_text(csg, one).program));
  }
  const testing::Setup fewer =
      random_view(view::Projection::orthographic, red_lines + "[effects.antialias]\nsamples = 4\nadaptive = true\n");
  const observe::Frame adaptive = testing::draw(testing::compile_text(csg, fewer).program);
  int wrong = 0;
  int wrong_adaptive = 0;
  for (std::size_t i = 0; i < picture.colour.size(); ++i) {
    const auto mean = [&](unsigned shift, unsigned from) {
      const std::size_t count = std::size_t{1} << shift;
      std::uint32_t sum = static_cast<std::uint32_t>(count) / 2;
      for (std::size_t f = 0; f < count; ++f) sum += frames[f].colour[i] >> from & 255U;
      return sum >> shift << from;
    };
    const auto all = [&](unsigned shift) { return mean(shift, 0) | mean(shift, 8) | mean(shift, 16); };
    wrong += picture.colour[i] != all(2);
    wrong_adaptive += adaptive.colour[i] != all(frames[0].colour[i] == frames[1].colour[i] ? 1 : 2);
  }
  CHECK(wrong == 0);
  CHECK(wrong_adaptive == 0);
}

TEST_CASE("drawing line by line or with a colour field does not change edge lines") {
  testing::Setup setup = random_view(view::Projection::perspective, red_lines);
  const std::string csg = testing::random_model(7, 6);
  const observe::Frame whole = testing::draw(testing::compile_text(csg, setup).program);
  setup.options.colouring = emit::Colouring::field;
  CHECK(whole.colour == testing::draw(testing::compile_text(csg, setup).program).colour);
  setup.kind = &scan_line::kind;
  CHECK(whole.colour == testing::draw(testing::compile_text(csg, setup).program).colour);
}
