#include <glm/common.hpp>

#include "host/lighting/lighting.h"
#include "host/read/read.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 64;
constexpr std::uint32_t height = 48;
const auto models = testing::cases<std::uint64_t>(30, 8);

struct Tally {
  int pixels = 0;
  int judged = 0;
  int mixed = 0;  ///< number of judged pixels that change if everything is opaque
  int wrong = 0;
  unsigned max_panes = 0;  ///< maximum at a pixel
};

/// Three opacities and opaque, selected by line of the file.
scene::Scene by_line(const std::vector<std::string>& sets) {
  scene::Scene scene = testing::scene_of("", sets);
  static constexpr std::array opacities{0.3, 1.0, 0.55, 1.0, 0.8};
  for (std::uint32_t line = 1; line < 80; ++line) {
    scene::MaterialRule rule;
    rule.from_line = line;
    rule.to_line = line;
    rule.opacity = opacities.at(line % opacities.size());
    scene.materials.push_back(rule);
  }
  return scene;
}

std::vector<double> opacities_of(const scene::Scene& scene, const model::Tree& tree) {
  std::vector<double> opacities;
  for (const model::Primitive& one : tree.primitives)
    opacities.push_back(lighting::make_finish(scene, one, false).opacity);
  return opacities;
}

/// The same model with its primitives in another order, which decides the owner of coincident surfaces.
model::Tree reordered(const model::Tree& tree, const std::vector<std::uint32_t>& order) {
  model::Tree other = tree;
  for (std::size_t i = 0; i < order.size(); ++i) other.primitives[i] = tree.primitives[order[i]];
  for (model::Node& node : other.nodes) {
    if (!node.is_leaf) continue;
    const auto place = std::find(order.begin(), order.end(), node.primitive);
    node.primitive = static_cast<std::uint32_t>(place - order.begin());
  }
  return other;
}

/// The ray of a pixel.
testing::Ray ray_at(const view::EyeSpace& eye, const glm::dvec2& place) {
  const glm::dvec3 away = eye.to_model(eye.from_picture({place.x, place.y, 1}));
  if (eye.perspective) return {eye.eye, away - eye.eye};
  return {eye.to_model(eye.from_picture({place.x, place.y, 0})), eye.axes.forward};
}

class Shot {
 public:
  Shot(std::uint64_t seed, view::Projection projection, scene::Scene scene) : scene_(std::move(scene)) {
    text_ = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 9));
    tree_ = read::read_csg_text(text_, "random");
    const facet::Box box = facet::make_geometry(tree_).box;
    is_empty_ = box.empty();
    if (is_empty_) return;
    const double turn = 0.7 * static_cast<double>(seed);
    const view::Camera direction{{std::cos(turn), std::sin(turn), 0.63}, {0, 0, 0}, projection};
    setup_ = testing::front_view(width, height, scene_);
    setup_.camera = view::view_all(direction, box, width, height);
    facets_ = std::make_unique<facet::Geometry>(facet::make_geometry(tree_));
  }

  /// Number of transparent surfaces in front of the first opaque one.
  [[nodiscard]] unsigned panes_at(std::size_t pixel) const {
    const testing::RayModel model(tree_, *facets_);
    const view::EyeSpace eye = view::eye_space(setup_.camera, setup_.sampling);
    const glm::dvec2 place(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
    const double from = eye.perspective ? 0 : -std::numeric_limits<double>::infinity();
    const std::vector<double> all = opacities();
    unsigned panes = 0;
    for (const testing::SurfacePoint& point : model.surfaces(ray_at(eye, place), {from}, 0).points) {
      if (all[point.primitive] == 1) break;
      ++panes;
    }
    return panes;
  }

  [[nodiscard]] bool is_empty() const { return is_empty_; }
  [[nodiscard]] const model::Tree& tree() const { return tree_; }
  [[nodiscard]] std::vector<double> opacities() const { return opacities_of(scene_, tree_); }
  [[nodiscard]] isa::Program program() const { return testing::compile_text(text_, setup_).program; }
  [[nodiscard]] observe::Frame drawn() const { return testing::draw(program()); }

  /// Casts rays with the primitives in the given order.
  [[nodiscard]] std::vector<testing::RayColour> cast(const std::vector<std::uint32_t>& order,
                                                     const testing::RayEffects& effects) const {
    const model::Tree tree = reordered(tree_, order);
    return testing::ray_picture(tree, facet::make_geometry(tree), scene_, {setup_.camera, width, height}, effects);
  }

  [[nodiscard]] std::vector<std::uint32_t> tree_order() const {
    std::vector<std::uint32_t> order(tree_.primitives.size());
    std::iota(order.begin(), order.end(), 0U);
    return order;
  }

 private:
  scene::Scene scene_;
  std::string text_;
  model::Tree tree_;
  std::unique_ptr<facet::Geometry> facets_;
  testing::Setup setup_;
  bool is_empty_ = false;
};

/// Opaque primitives come first, according to the rule for coincident surfaces.
std::vector<std::uint32_t> opaque_first(const Shot& shot) {
  std::vector<std::uint32_t> order = shot.tree_order();
  const std::vector<double> opacities = shot.opacities();
  std::stable_partition(order.begin(), order.end(), [&](std::uint32_t one) { return opacities[one] == 1; });
  return order;
}

template <class Value>
std::vector<Value> permuted(const std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
  std::vector<Value> result;
  for (const std::uint32_t one : order) result.push_back(values[one]);
  return result;
}

Tally layers_of_random_models(std::uint64_t first_seed, view::Projection projection, unsigned layers) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + models; ++seed) {
    CAPTURE(seed);
    const Shot shot(seed, projection, by_line({fmt::format("effects.transparency.layers={}", layers)}));
    if (shot.is_empty()) continue;
    const std::vector<std::uint32_t> order = opaque_first(shot);
    testing::RayEffects effects;
    effects.opacity = permuted(shot.opacities(), order);
    effects.layers = 100;
    const auto expected = shot.cast(order, effects);
    const auto opaque = shot.cast(order, {});
    const observe::Frame frame = shot.drawn();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ++tally.pixels;
      if (!expected[i].is_certain) continue;
      ++tally.judged;
      tally.mixed += glm::distance(expected[i].colour, opaque[i].colour) > 0.01 ? 1 : 0;
      // Allows one level per pane, and half a level for rounding of the colours.
      const unsigned panes = shot.panes_at(i);
      tally.max_panes = std::max(tally.max_panes, panes);
      if (panes <= layers && testing::colour_error(frame.colour[i], expected[i].colour) <= panes + 0.5 + 1e-6) continue;
      ++tally.wrong;
      MESSAGE("seed ", seed, " column ", i % width, " row ", i / width, ": off by ",
              testing::colour_error(frame.colour[i], expected[i].colour));
    }
  }
  return tally;
}

/// Whether a primitive's surfaces are drawn at a pixel: fewer than 16 * opacity of the 16 thresholds precede the
/// pixel's.
bool is_drawn_at(std::uint32_t x, std::uint32_t y, double opacity) {
  const std::uint32_t number = 8 * ((x + y) % 2) + 4 * (y % 2) + 2 * ((x + y) / 2 % 2) + y / 2 % 2;
  return number < std::round(16 * opacity);
}

Tally screen_doors_of_random_models(std::uint64_t first_seed, view::Projection projection) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + models; ++seed) {
    const Shot shot(seed, projection, by_line({"effects.transparency.method=screen-door"}));
    if (shot.is_empty()) continue;
    // The oracle reports only the first of coincident surfaces; pixels where their order matters are not judged.
    std::array<std::vector<testing::RayColour>, 2> expected;
    for (const bool is_reversed : {false, true}) {
      std::vector<std::uint32_t> order = shot.tree_order();
      if (is_reversed) std::reverse(order.begin(), order.end());
      const std::vector<double> opacities = permuted(shot.opacities(), order);
      testing::RayEffects effects;
      effects.is_there = [&opacities](std::uint32_t x, std::uint32_t y, std::uint32_t primitive) {
        return is_drawn_at(x, y, opacities[primitive]);
      };
      expected.at(is_reversed ? 1 : 0) = shot.cast(order, effects);
    }
    const auto opaque = shot.cast(shot.tree_order(), {});
    const observe::Frame frame = shot.drawn();
    for (std::size_t i = 0; i < opaque.size(); ++i) {
      ++tally.pixels;
      const testing::RayColour& one = expected[0][i];
      if (!one.is_certain || one.colour != expected[1][i].colour) continue;
      ++tally.judged;
      tally.mixed += one.colour != opaque[i].colour ? 1 : 0;
      if (testing::colour_error(frame.colour[i], one.colour) <= 0.5 + 1e-6) continue;
      ++tally.wrong;
      MESSAGE("seed ", seed, " column ", i % width, " row ", i / width);
    }
  }
  return tally;
}

/// Depth in steps of a surface at a distance from the eye along the view axis.
double steps_at(const isa::Program& program, double distance) {
  const isa::DepthScale& scale = program.facts->depth_scale;
  const double most = std::exp2(isa::find_field(program, isa::FieldRole::depth).width) - 4;
  const auto place = [&](double at) { return scale.perspective ? 1 / scale.near - 1 / at : at - scale.near; };
  return 1 + most * place(distance) / place(scale.far);
}

/// Whether owner and depth of the picture match the surface hit by the ray.
bool is_reported(const isa::Program& program, const testing::RayColour& seen, const std::vector<std::uint32_t>& order,
                 std::uint32_t owner, std::uint32_t depth) {
  if (seen.primitive == model::no_index)
    return owner == observe::no_owner && depth + 1 == 1U << isa::find_field(program, isa::FieldRole::depth).width;
  return owner == order[seen.primitive] && std::abs(depth - steps_at(program, seen.depth)) <= 2;
}

Tally surfaces_of_random_models(std::uint64_t first_seed, view::Projection projection, const std::string& set) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + models; ++seed) {
    const Shot shot(seed, projection, by_line({set}));
    if (shot.is_empty()) continue;
    const std::vector<std::uint32_t> order = opaque_first(shot);
    const std::vector<double> opacities = permuted(shot.opacities(), order);
    const auto nearest = shot.cast(order, {});
    const isa::Program program = shot.program();
    const observe::Frame frame = testing::draw(program);
    const observe::Frame opaque = observe::with_opaque_surfaces(frame);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      ++tally.pixels;
      if (!nearest[i].is_certain) continue;
      ++tally.judged;
      const bool is_glass = nearest[i].primitive != model::no_index && opacities[nearest[i].primitive] < 1;
      tally.mixed += is_glass ? 1 : 0;
      const bool is_right = is_reported(program, nearest[i], order, frame.owner[i], frame.depth[i]);
      const bool is_right_behind = is_glass ? opaque.depth[i] > frame.depth[i]
                                            : opaque.depth[i] == frame.depth[i] && opaque.owner[i] == frame.owner[i];
      if (is_right && is_right_behind) continue;
      ++tally.wrong;
      MESSAGE("seed ", seed, " column ", i % width, " row ", i / width, ": ", frame.owner[i], " at ", frame.depth[i]);
    }
  }
  return tally;
}

void check(const Tally& tally) {
  MESSAGE(tally.pixels, " pixels, ", tally.judged, " judged, ", tally.mixed, " transparent, ", tally.wrong, " wrong");
  CHECK(tally.wrong == 0);
  CHECK(tally.judged > tally.pixels * 3 / 4);
  CHECK(tally.mixed > tally.pixels / 50);
}

}  // namespace

TEST_CASE("transparent layers of random models match rays in orthographic views") {
  const Tally tally = layers_of_random_models(1, view::Projection::orthographic, 12);
  check(tally);
  CHECK((!testing::draws_usual_cases() || tally.max_panes >= 3));
}
TEST_CASE("transparent layers of random models match rays in perspective views") {
  const Tally tally = layers_of_random_models(101, view::Projection::perspective, 12);
  check(tally);
  CHECK((!testing::draws_usual_cases() || tally.max_panes >= 3));
}
TEST_CASE("screen doors of random models match rays in orthographic views") {
  check(screen_doors_of_random_models(1, view::Projection::orthographic));
}
TEST_CASE("screen doors of random models match rays in perspective views") {
  check(screen_doors_of_random_models(101, view::Projection::perspective));
}
TEST_CASE("owner and depth are those of the nearest surface even if transparent") {
  for (const char* const set : {"effects.transparency.layers=12", "effects.transparency.layers=1"}) {
    CAPTURE(set);
    check(surfaces_of_random_models(1, view::Projection::orthographic, set));
    check(surfaces_of_random_models(101, view::Projection::perspective, set));
  }
}
