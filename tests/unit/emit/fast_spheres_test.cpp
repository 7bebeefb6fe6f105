#include "host/emit/fast_spheres.h"

#include <rapidcheck.h>

#include <glm/vec3.hpp>

#include "host/emit/compile.h"
#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

struct Ball {
  glm::dvec3 at;
  double radius;
};

/// A first sphere, and the operators that combine it with the others in turn.
struct Model {
  std::vector<Ball> balls;
  std::vector<char> operators;  ///< '+', '-' or '*', one for each sphere after the first
  glm::dvec3 eye{0, 0.04, 40};  ///< distance from the origin equals the picture's width

  [[nodiscard]] std::string text() const {
    std::string text = ball(0);
    for (std::size_t i = 1; i < balls.size(); ++i) {
      const char op = operators[i - 1];
      text = fmt::format("{}(){{{}{}}}",
                         op == '+'   ? "union"
                         : op == '-' ? "difference"
                                     : "intersection",
                         text, ball(i));
    }
    return text;
  }

 private:
  [[nodiscard]] std::string ball(std::size_t i) const {
    const Ball& one = balls[i];
    return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{sphere($fn=0,$fa=12,$fs=2,r={});}}",
                       one.at.x, one.at.y, one.at.z, one.radius);
  }
};

double real(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

Model random_model() {
  Model model;
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    // The first sphere determines the depth range; the depths of the others must fit the machine's numbers.
    const double radius = *rc::gen::element(i == 0 ? 1.0 : 0.02, real(0.3, 2), real(2, 7));
    model.balls.push_back({{real(-6, 6), real(-6, 6), real(-6, 6)}, radius});
    if (i > 0) model.operators.push_back(*rc::gen::element('+', '-', '*'));
  }
  model.eye = glm::dvec3(real(-1, 1), real(-1, 1), real(0.5, 1)) * *rc::gen::element(8.0, 25.0, 50.0);
  return model;
}

struct Drawn {
  view::View view;
  isa::Program program;
  observe::Frame frame;
};

machines::Machine machine_of(const std::string& name, const view::Sampling& sampling) {
  machines::Machine machine = kinds::load(name);
  machines::set_picture_size(machine, {sampling.width, sampling.height});
  machine.array.memory_bits = 1024;
  return machine;
}

observe::Frame run(engine::Engine& engine, const isa::Program& program) {
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  const engine::RunResult result = engine.run(program, observers);
  RC_ASSERT(result.overflows == 0U);
  return frame.frame();
}

/// A model together with its geometry and view.
struct Viewed {
  Viewed(const Model& model, const view::Sampling& sampling)
      : tree(read::read_csg_text(model.text(), "test")),
        scene(facet::make_geometry(tree, {.exact_curves = true, .fast_spheres = true})),
        view(view::make_view(scene, tree, {model.eye, {0, 0, 0}, view::Projection::orthographic}, sampling)) {}

  model::Tree tree;
  facet::Geometry scene;
  view::View view;
};

/// Whether the coefficients of all its spheres fit the machine's integers; other spheres must be faceted.
bool fits(const Model& model, const view::Sampling& sampling) {
  const Viewed viewed(model, sampling);
  return std::none_of(viewed.view.quadrics.begin(), viewed.view.quadrics.end(), [](const view::ScreenQuadric& quadric) {
    return quadric.kind == view::ScreenQuadricKind::unfit;
  });
}

Drawn draw(const Model& model, const view::Sampling& sampling, const std::string& machine_name = "pixel-planes-4",
           const emit::Options& options = {}) {
  const Viewed viewed(model, sampling);
  const machines::Machine machine = machine_of(machine_name, sampling);
  Drawn drawn{viewed.view, emit::compile(viewed.tree, viewed.scene, viewed.view, machine, options), {}};
  isa::validate(drawn.program);
  drawn.frame = run(*engine::make_functional_engine(machine, 1), drawn.program);
  return drawn;
}

/// Part of a ray, in depth steps.
struct Part {
  double near;
  double far;
};

/// The model in double precision along the rays of one view.
class Plain {
 public:
  Plain(const Model& model, const view::View& view) : model_(model) {
    const view::EyeSpace space = view::eye_space(view.camera, view.sampling);
    const double steps = (std::exp2(view.sampling.z_bits) - 4.0) / (view.depth.far - view.depth.near);
    for (const Ball& ball : model.balls) {
      const glm::dvec3 in_eye = space.to_eye(ball.at);
      Seen seen{(view.sampling.width - 1.0) / 2 + in_eye.x / space.pixel,
                (view.sampling.height - 1.0) / 2 - in_eye.y / space.pixel, ball.radius / space.pixel,
                1.0 + (in_eye.z - view.depth.near) * steps};
      const double square = seen.radius * seen.radius;
      const double half = ball.radius * steps;
      seen.factor = factor((half - 1.0) / square);
      const double rounding = (3.0 + 2.0 * seen.radius) / 256;
      seen.slack = 4.0 + seen.factor * rounding;
      seen.unsure = factor((half - 1.0 - 1e-6 * half) / (square + rounding)) != seen.factor;
      seen_.push_back(seen);
    }
  }

  /// Computes the visible depth at a pixel, if any, and its tolerance. Returns false if rounding may decide.
  bool at(int x, int y, std::optional<double>& depth, double& slack) const {
    slack = 0;
    std::vector<Part> in;
    std::vector<double> depths;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const Seen& one = seen_[i];
      const double away = std::hypot(x - one.column, y - one.row);
      if (std::abs(away - one.radius) < (one.radius < 0.5 ? 0.5 : 1.0 / 64)) return false;
      std::vector<Part> ball;
      if (away < one.radius) {
        if (one.unsure) return false;
        slack = std::max(slack, one.slack);
        const double half = one.factor * (one.radius * one.radius - away * away);
        ball.push_back({one.middle - half, one.middle + half});
        depths.insert(depths.end(), {ball[0].near, ball[0].far});
      }
      in = i == 0 ? ball : combined(in, ball, model_.operators[i - 1]);
    }
    std::sort(depths.begin(), depths.end());
    for (std::size_t i = 1; i < depths.size(); ++i)
      if (depths[i] - depths[i - 1] < 2 * slack) return false;
    if (!in.empty()) depth = in.front().near;
    return true;
  }

 private:
  struct Seen {
    double column;
    double row;
    double radius;
    double middle;
    double factor = 0;
    double slack = 0;     ///< tolerance of the machine's depths
    bool unsure = false;  ///< true if rounding decides, close to a sum of two powers
  };

  /// The largest 2^i or 2^i +/- 2^j, with j from i - 4, that does not exceed `most`.
  static double factor(double most) {
    double best = 0;
    for (int i = -40; i <= 40; ++i) {
      for (int j = i - 4; j <= i; ++j) {
        for (const double sign : {-1.0, 0.0, 1.0}) {
          const double one = std::exp2(i) + sign * (j == i ? 0.0 : std::exp2(j));
          if (one <= most) best = std::max(best, one);
        }
      }
    }
    return best;
  }

  static bool holds(const std::vector<Part>& parts, double z) {
    return std::any_of(parts.begin(), parts.end(), [&](const Part& one) { return z >= one.near && z < one.far; });
  }

  static std::vector<Part> combined(const std::vector<Part>& a, const std::vector<Part>& b, char op) {
    std::vector<double> ends;
    for (const Part& one : a) ends.insert(ends.end(), {one.near, one.far});
    for (const Part& one : b) ends.insert(ends.end(), {one.near, one.far});
    std::sort(ends.begin(), ends.end());
    std::vector<Part> parts;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double z = (ends[i - 1] + ends[i]) / 2;
      const bool in_a = holds(a, z);
      const bool in_b = holds(b, z);
      const bool is_in = op == '+' ? in_a || in_b : op == '-' ? in_a && !in_b : in_a && in_b;
      if (!is_in || ends[i - 1] >= ends[i]) continue;
      if (!parts.empty() && parts.back().far == ends[i - 1])
        parts.back().far = ends[i];
      else
        parts.push_back({ends[i - 1], ends[i]});
    }
    return parts;
  }

  const Model& model_;
  std::vector<Seen> seen_;
};

view::Sampling random_sampling() {
  view::Sampling sampling;
  sampling.width = static_cast<std::uint32_t>(*rc::gen::inRange(5, 70));
  sampling.height = static_cast<std::uint32_t>(*rc::gen::inRange(5, 70));
  sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(10, 25));
  return sampling;
}

}  // namespace

TEST_CASE("combinations of fast spheres match circles and paraboloids in doubles") {
  int checked = 0;
  int seen = 0;
  for (int round = 0; round < 6; ++round) {
    CHECK(rc::check([&] {
      const Model model = random_model();
      const view::Sampling sampling = random_sampling();
      RC_PRE(fits(model, sampling));
      const Drawn drawn = draw(model, sampling);
      const Plain plain(model, drawn.view);
      const std::uint64_t nothing = (std::uint64_t{1} << sampling.z_bits) - 1;
      for (std::uint32_t y = 0; y < sampling.height; ++y) {
        for (std::uint32_t x = 0; x < sampling.width; ++x) {
          std::optional<double> expected;
          double slack = 0;
          if (!plain.at(static_cast<int>(x), static_cast<int>(y), expected, slack)) continue;
          const std::uint32_t depth = drawn.frame.depth[y * sampling.width + x];
          ++checked;
          // The part in front of the depth range is drawn at its first step.
          if (expected) expected = std::max(0.0, *expected);
          RC_ASSERT(expected.has_value() == (depth != nothing));
          if (!expected) continue;
          ++seen;
          RC_ASSERT(std::abs(*expected - depth) <= slack);
        }
      }
    }));
  }
  MESSAGE(checked, " pixels, ", seen, " with a sphere");
  CHECK((!testing::draws_usual_cases() || seen > 4'000));
  CHECK((!testing::draws_usual_cases() || checked > seen + 1'000));
}

TEST_CASE("depths of a fast sphere and a hollow match screen_quadric.h exactly") {
  int hollow = 0;
  for (int round = 0; round < 4; ++round) {
    CHECK(rc::check([&] {
      Model model = random_model();
      model.balls.resize(2);
      // Centred on the visible side of the first sphere.
      const double radius = model.balls[0].radius;
      model.balls[1] = {model.balls[0].at + glm::normalize(model.eye) * radius, radius * real(0.2, 1.2)};
      model.operators = {'-'};
      const view::Sampling sampling = random_sampling();
      RC_PRE(fits(model, sampling));
      const Drawn drawn = draw(model, sampling);
      const std::int64_t top = (std::int64_t{1} << sampling.z_bits) - 1;
      struct Depths {
        bool is_met;
        std::int64_t near;
        std::int64_t far;
      };
      const auto depths = [&](std::size_t number, std::int32_t x, std::int32_t y) {
        const view::ScreenQuadric& quadric = drawn.view.quadrics.at(number);
        const std::int64_t value = view::value_at(quadric.discriminant, x, y);
        const unsigned shift = quadric.discriminant_shift + quadric.factor.fraction();
        const std::int64_t part = quadric.factor.scaled() * value;
        const std::int64_t middle = quadric.middle.c >> sampling.fraction_bits;
        return Depths{value >= 0, middle + (-part >> shift), middle + (part >> shift) + 1};
      };
      for (std::int32_t y = 0; y < static_cast<std::int32_t>(sampling.height); ++y) {
        for (std::int32_t x = 0; x < static_cast<std::int32_t>(sampling.width); ++x) {
          const Depths whole = depths(0, x, y);
          const Depths taken = depths(1, x, y);
          std::int64_t expected = top;
          if (whole.is_met) expected = std::max<std::int64_t>(0, whole.near);
          if (whole.is_met && taken.is_met && taken.near <= whole.near && taken.far > whole.near) {
            expected = taken.far < whole.far ? taken.far : top;
            hollow += taken.far < whole.far ? 1 : 0;
          }
          RC_ASSERT(drawn.frame.depth[static_cast<std::size_t>(y) * sampling.width + static_cast<std::size_t>(x)] ==
                    static_cast<std::uint32_t>(expected));
        }
      }
    }));
  }
  CHECK((!testing::draws_usual_cases() || hollow > 200));
}

TEST_CASE("pictures of fast spheres are identical on all machines and strategies") {
  CHECK(rc::check([] {
    const Model model = random_model();
    const view::Sampling sampling = random_sampling();
    RC_PRE(fits(model, sampling));
    const Drawn drawn = draw(model, sampling);
    const machines::Machine machine = machine_of("pixel-planes-4", sampling);
    RC_ASSERT(run(*engine::make_reference_engine(machine), drawn.program) == drawn.frame);
    for (const char* const name : {"scan-line", "pixel-powers", "pixel-square+divider.kind=host",
                                   "pixel-square+divider.kind=host+array.width=16+array.height=8"}) {
      const observe::Frame other = draw(model, sampling, name).frame;
      RC_ASSERT(other.depth == drawn.frame.depth);
      RC_ASSERT(other.owner == drawn.frame.owner);
      RC_ASSERT(other.colour == drawn.frame.colour);
    }
    for (const emit::Strategy strategy : emit::strategies) {
      emit::Options options;
      options.strategy = strategy;
      options.stack_bits = 4;
      if (strategy == emit::Strategy::automatic) options.colouring = emit::Colouring::field;
      options.pruning = *rc::gen::element(csg::Pruning{}, csg::Pruning{false, false, false, false, false, false});
      const observe::Frame other = draw(model, sampling, "pixel-planes-4", options).frame;
      RC_ASSERT(other.depth == drawn.frame.depth);
      RC_ASSERT(other.colour == drawn.frame.colour);
    }
  }));
}

TEST_CASE("spheres shaded in the bits of their depth equal those shaded in a separate field") {
  const Model model{{{{0, 0, 0}, 6}, {{4, 1, 2}, 4}, {{-5, 2, 1}, 4.5}}, {'+', '+'}};
  view::Sampling sampling;
  sampling.width = 120;
  sampling.height = 90;
  const auto has_field = [](const isa::Program& program, const std::string& name) {
    return std::any_of(program.facts->fields.begin(), program.facts->fields.end(),
                       [&](const isa::NamedField& one) { return one.name == name; });
  };
  for (const unsigned colour_bits : {24U, 15U}) {
    sampling.z_bits = colour_bits == 24 ? 22 : 18;
    emit::Options options;
    options.colour_bits = colour_bits;
    const Drawn in_place = draw(model, sampling, "pixel-planes-4", options);
    options.colouring = emit::Colouring::field;
    const Drawn apart = draw(model, sampling, "pixel-planes-4", options);
    CHECK_FALSE(has_field(in_place.program, "sum"));
    CHECK_FALSE(has_field(in_place.program, "kept"));
    CHECK(has_field(apart.program, "sum"));
    CHECK(in_place.frame == apart.frame);
  }
  Model cut = model;
  cut.operators.back() = '-';
  sampling.z_bits = 22;
  CHECK(has_field(draw(cut, sampling).program, "sum"));
}

TEST_CASE("the field of squares has no linear part and the minimum width") {
  /// Reads the field once, after the first set_constant from instruction 3 on, when all depths are the farthest.
  struct Look : engine::Observer {
    isa::Field field;
    std::vector<std::uint32_t> values;
    isa::Region region;
    void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
      if (step.instruction.opcode != isa::Opcode::set_constant || !values.empty() || step.index < 3) return;
      region = state.region();
      values.resize(std::size_t{region.width} * region.height);
      state.read_field(field, values);
    }
  };
  const Model model{{{{0, 0, 0}, 3}}, {}};
  for (const auto& [width, height, bits] :
       {std::array{512U, 512U, 17U}, {64U, 64U, 11U}, {37U, 20U, 9U}, {5U, 1U, 3U}}) {
    view::Sampling sampling;
    sampling.width = width;
    sampling.height = height;
    CHECK(emit::squares_bits({0, 0, width, height}) == bits);
    const isa::Program program = draw(model, sampling).program;
    Look look;
    for (const isa::NamedField& one : program.facts->fields)
      if (one.name == "squares") look.field = one.field;
    REQUIRE(look.field.width == bits);
    const std::array<engine::Observer*, 1> observers{&look};
    engine::make_functional_engine(machine_of("pixel-planes-4", sampling), 1)->run(program, observers);
    REQUIRE(look.values.size() == std::size_t{width} * height);
    int wrong = 0;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const auto square = [](std::uint32_t at, std::uint32_t side) {
          const double from_middle = at - (side - 1) / 2.0;
          return static_cast<std::uint32_t>(std::floor(from_middle * from_middle));
        };
        wrong += look.values[y * width + x] != square(x, width) + square(y, height) ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("the squares take 378 clocks and a fast sphere far fewer than its facets") {
  view::Sampling sampling;
  const Drawn drawn = draw({{{{0, 0, 0}, 10}}, {}}, sampling);
  std::uint64_t squares = 0;
  std::uint64_t render = 0;
  const machines::Machine machine = machine_of("pixel-planes-4", sampling);
  bool has_begun = false;
  for (const isa::Instruction& one : drawn.program.segments.at(0).instructions) {
    const std::uint64_t clocks = machines::bit_serial_clocks(one, machine);
    // The picture starts with the farthest depth everywhere.
    has_begun = has_begun || (one.opcode == isa::Opcode::set_constant && one.fields[0].width == sampling.z_bits);
    if (!has_begun) squares += clocks;
    if (one.origin.purpose == isa::Purpose::render) render += clocks;
  }
  CHECK(squares == 379);  // includes one that enables all pixels for the next instruction
  CHECK(render < 200);
}
