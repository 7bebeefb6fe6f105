#include <rapidcheck.h>

#include <glm/vec3.hpp>

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

// Spheres without comparisons. The expected depth is the formula of host/view/screen_quadric.h for every pixel of the
// picture, independent of extents and regions.

namespace {

struct Ball {
  glm::dvec3 at{0};
  double radius = 1;
};

double random_real(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

std::string text_of(const std::vector<Ball>& balls) {
  std::string text;
  for (const Ball& one : balls)
    text += fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{sphere($fn=0,$fa=12,$fs=2,r={});}}",
                        one.at.x, one.at.y, one.at.z, one.radius);
  return text;
}

std::int64_t floor_root(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

/// The nearest depth at each pixel, all ones for background.
std::vector<std::uint32_t> depths_of(const view::View& view) {
  const view::Sampling& sampling = view.sampling;
  const std::int64_t farthest = (std::int64_t{1} << sampling.z_bits) - 1;
  std::vector<std::uint32_t> depths;
  for (std::int32_t y = 0; y < static_cast<std::int32_t>(sampling.height); ++y) {
    for (std::int32_t x = 0; x < static_cast<std::int32_t>(sampling.width); ++x) {
      std::int64_t nearest = farthest;
      for (const view::ScreenQuadric& one : view.quadrics) {
        const std::int64_t discriminant = view::value_at(one.discriminant, x, y) >> one.discriminant_shift;
        if (discriminant < 0) continue;
        const view::FixedLinear& middle = one.middle;
        const std::int64_t at = (middle.a * x + middle.b * y + middle.c) >> sampling.fraction_bits;
        nearest = std::min(nearest, std::max<std::int64_t>(0, at - (floor_root(discriminant) << one.unit)));
      }
      depths.push_back(static_cast<std::uint32_t>(nearest));
    }
  }
  return depths;
}

testing::Setup setup_of(const glm::dvec3& eye, std::uint32_t width, std::uint32_t height) {
  testing::Setup setup{{eye, {0, 0, 0}, view::Projection::orthographic}, {}, 256};
  setup.exact_curves = true;
  setup.sampling.width = width;
  setup.sampling.height = height;
  return setup;
}

bool has_field(const isa::Program& program, const std::string& name) {
  return std::any_of(program.facts->fields.begin(), program.facts->fields.end(),
                     [&](const isa::NamedField& one) { return one.name == name; });
}

std::size_t edges_of(const isa::Program& program) {
  std::size_t count = 0;
  for (const isa::Segment& segment : program.segments)
    count += static_cast<std::size_t>(
        std::count_if(segment.instructions.begin(), segment.instructions.end(), [](const isa::Instruction& one) {
          return one.opcode == isa::Opcode::edge_not_negative || one.opcode == isa::Opcode::edge_negative;
        }));
  return count;
}

/// Throws if an expression overflows.
observe::Frame draw(const testing::Setup& setup, const isa::Program& program) {
  if (setup.machine.empty()) return testing::draw(program);
  machines::Machine machine = kinds::load(setup.machine);
  machine.evaluator_degree = 2;
  return testing::draw_on(std::move(machine), program);
}

const std::string squares = "pixel-square+divider.kind=host+array.width=16+array.height=";

}  // namespace

TEST_CASE("spheres without comparisons match their formula for every kind of region") {
  int seen = 0;
  int in_candidate = 0;
  int fewer_edges = 0;
  for (int round = 0; round < 2; ++round) {
    CHECK(rc::check([&] {
      std::vector<Ball> balls;
      const int count = *rc::gen::inRange(1, 5);
      for (int i = 0; i < count; ++i) {
        // Some extend past the picture, some are smaller than a pixel, and some are behind others.
        const double radius = *rc::gen::element(random_real(0.01, 0.5), random_real(0.5, 3), random_real(3, 7));
        const glm::dvec3 at = i > 0 && *rc::gen::arbitrary<bool>()
                                  ? balls[0].at * random_real(-1, 1)
                                  : glm::dvec3(random_real(-9, 9), random_real(-9, 9), random_real(-9, 9));
        balls.push_back({at, radius});
      }
      const glm::dvec3 eye =
          glm::normalize(glm::dvec3(random_real(-1, 1), random_real(-1, 1), random_real(0.3, 1))) * random_real(15, 45);
      testing::Setup setup = setup_of(eye, static_cast<std::uint32_t>(*rc::gen::inRange(9, 70)),
                                      static_cast<std::uint32_t>(*rc::gen::inRange(9, 70)));
      setup.sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(10, 25));
      setup.options.colour_bits = *rc::gen::element(24U, 15U, 6U);
      const testing::Compiled compiled = testing::compile_text(text_of(balls), setup);
      const std::vector<std::uint32_t> expected = depths_of(compiled.view);
      const observe::Frame frame = draw(setup, compiled.program);
      RC_ASSERT(frame.depth == expected);
      const auto farthest = (std::uint32_t{1} << setup.sampling.z_bits) - 1;
      seen +=
          static_cast<int>(expected.size()) - static_cast<int>(std::count(expected.begin(), expected.end(), farthest));
      in_candidate += has_field(compiled.program, "root") || compiled.view.quadrics.empty() ? 0 : 1;
      fewer_edges += edges_of(compiled.program) < 4U * balls.size() ? 1 : 0;

      testing::Setup other = setup;
      other.options.colouring = emit::Colouring::field;
      const isa::Program apart = testing::compile_again(compiled, other);
      RC_ASSERT(has_field(apart, "root") == has_field(apart, "sum"));
      RC_ASSERT(draw(other, apart) == frame);

      other = setup;
      other.options.strategy = *rc::gen::elementOf(std::vector(emit::strategies.begin(), emit::strategies.end()));
      other.options.stack_bits = 4;
      other.options.pruning = *rc::gen::element(csg::Pruning{}, csg::Pruning{false, false, false, false, false, false});
      RC_ASSERT(draw(other, testing::compile_again(compiled, other)) == frame);

      other = setup;
      other.machine = *rc::gen::element<std::string>("scan-line", "pixel-powers", squares + "8", squares + "32");
      const observe::Frame parts = draw(other, testing::compile_again(compiled, other));
      RC_ASSERT(parts.depth == frame.depth);
      RC_ASSERT(parts.colour == frame.colour);
    }));
  }
  MESSAGE(seen, " pixels with a sphere, ", in_candidate, " pictures with roots in Z1, ", fewer_edges,
          " with fewer edges");
  CHECK((!testing::draws_usual_cases() || seen > 15'000));
  CHECK((!testing::draws_usual_cases() || in_candidate > 50));
  CHECK((!testing::draws_usual_cases() || fewer_edges > 50));
}

TEST_CASE("lone spheres need no root field unless one cuts another or colours have a field") {
  testing::Setup setup = setup_of({0, 0.04, 60}, 64, 64);
  const std::vector<Ball> balls{{{0, 0, 0}, 6}, {{2, 1, 3}, 4}};
  const isa::Program alone = testing::compile_text(text_of(balls), setup).program;
  CHECK_FALSE(has_field(alone, "root"));
  CHECK(edges_of(alone) == 0);
  const testing::Compiled cut = testing::compile_text("difference(){" + text_of(balls) + "}", setup);
  CHECK(has_field(cut.program, "root"));
  setup.options.colouring = emit::Colouring::field;
  CHECK(has_field(testing::compile_text(text_of(balls), setup).program, "root"));
}

TEST_CASE("a sphere larger than a region is cut only at the border of the region") {
  testing::Setup setup = setup_of({0, 0.04, 60}, 64, 64);
  setup.machine = squares + "16";
  const testing::Compiled compiled = testing::compile_text(text_of({{{0, 0, 0}, 6}}), setup);
  CHECK(compiled.program.segments.size() == 16);
  CHECK(edges_of(compiled.program) == 0);
  CHECK(draw(setup, compiled.program).depth == depths_of(compiled.view));
}
