#include <rapidcheck.h>

#include <glm/common.hpp>

#include "host/effects/layers.h"
#include "host/effects/rows.h"
#include "host/effects/screen_door.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/pixel_square/kind.h"
#include "hw/scan_line/kind.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;
using testing::box_text;
using testing::front_view;
using testing::plain_colours;
using testing::scene_of;
using testing::tinted;

namespace {

constexpr std::uint32_t side = 8;
constexpr double top = 255;

struct Pane {
  glm::dvec3 colour;
  double alpha = 1;
};

/// Panes that cover the whole picture, one behind the other.
std::string panes_text(const std::vector<Pane>& panes) {
  std::string text = "union(){";
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const auto y = static_cast<double>(2 * i);
    text += tinted(panes[i].colour, panes[i].alpha, box_text({-1, y, -9}, {9, y + 1, 1}));
  }
  return text + "}";
}

/// Blends the nearest transparent panes and the opaque one behind them; colours are rounded to levels first.
glm::dvec3 blended(const std::vector<Pane>& panes, std::size_t layers) {
  glm::dvec3 sum{0};
  double left = 1;
  for (const Pane& pane : panes) {
    const bool is_opaque = pane.alpha == 1;
    if (!is_opaque && layers == 0) continue;
    sum += left * pane.alpha * glm::round(top * pane.colour);
    left *= 1 - pane.alpha;
    if (!is_opaque) --layers;
  }
  return sum;
}

glm::dvec3 levels(std::uint32_t packed) {
  const std::array<std::uint8_t, 3> colour = isa::unpack_colour(packed, isa::max_colour_bits);
  return {colour[0], colour[1], colour[2]};
}

double greatest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

observe::Frame drawn(const std::string& csg, const testing::Setup& setup) {
  return testing::draw(testing::compile_text(csg, setup).program);
}

observe::Frame drawn(const std::string& csg, const std::vector<std::string>& sets) {
  return drawn(csg, front_view(side, side, scene_of(plain_colours, sets)));
}

/// Boxes, a sphere and a hole, transparent and opaque, that overlap and touch without coplanar faces.
std::vector<std::string> parts() {
  const std::string hole =
      "difference(){" + box_text({3, 8, -13}, {15, 9, -2}) + box_text({7, 7, -9}, {11, 10, -5}) + "}";
  return {tinted({0.9, 0.2, 0.2}, 0.5, box_text({1, 1, -11}, {8, 4, -1.5})), tinted({0.2, 0.8, 0.3}, 0.25, hole),
          tinted({0.2, 0.3, 0.9}, 0.7,
                 "multmatrix([[1,0,0,9],[0,1,0,6],[0,0,1,-9],[0,0,0,1]])"
                 "{sphere($fn=12,$fa=12,$fs=2,r=4);}"),
          tinted({0.8, 0.8, 0.7}, 1, box_text({5, 2.5, -15}, {14, 12, -10})),
          tinted({0.6, 0.1, 0.7}, 0.5, box_text({2.5, 0.5, -7}, {13, 14, -6}))};
}

std::string union_of(const std::vector<std::string>& parts) {
  std::string text = "union(){";
  for (const std::string& part : parts) text += part;
  return text + "}";
}

bool same(const observe::Frame& a, const observe::Frame& b) {
  return a.colour == b.colour && a.depth == b.depth &&
         observe::with_opaque_surfaces(a).depth == observe::with_opaque_surfaces(b).depth;
}

testing::Setup view_of_parts(const std::vector<std::string>& sets) { return front_view(16, 16, scene_of("", sets)); }

struct NoSettings {};

void visit_keys(NoSettings& /*settings*/, const auto& /*visit*/) {}

class AlwaysCalled final : public emit::EffectOf<NoSettings> {
 public:
  bool is_implied_by(const emit::Look& /*look*/) const override { return true; }
};

}  // namespace

TEST_CASE("blending of panes has an error of at most one level per pane") {
  const bool holds = rc::check("the picture blends the panes at each pixel", [] {
    std::vector<Pane> panes;
    const int count = *rc::gen::inRange(1, 7);
    const auto part = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
    for (int i = 0; i < count; ++i) panes.push_back({{part(), part(), part()}, *rc::gen::inRange(1, 998) / 1000.0});
    if (*rc::gen::arbitrary<bool>()) panes.push_back({{part(), part(), part()}, 1});
    const glm::dvec3 expected = blended(panes, panes.size());
    const observe::Frame frame = drawn(panes_text(panes), std::vector<std::string>{});
    for (const std::uint32_t pixel : frame.colour) RC_ASSERT(greatest(levels(pixel) - expected) <= count);
  });
  CHECK(holds);
}

TEST_CASE("a pixel with too many panes shows the nearest ones and the opaque surface") {
  const std::vector<Pane> panes{{{1, 0, 0}, 0.5}, {{0, 1, 0}, 0.5}, {{0, 0, 1}, 0.5}, {{1, 1, 1}, 1}};
  for (const unsigned layers : {1U, 2U, 3U, 4U}) {
    CAPTURE(layers);
    const observe::Frame frame = drawn(panes_text(panes), {fmt::format("effects.transparency.layers={}", layers)});
    CHECK(greatest(levels(frame.colour.front()) - blended(panes, layers)) <= std::min(layers, 3U));
  }
}

TEST_CASE("a wall is unchanged through a hole in glass and tinted through the glass") {
  const std::string glass = "difference(){" + box_text({0, 0, -8}, {8, 1, 0}) + box_text({2, -1, -6}, {6, 2, -2}) + "}";
  const observe::Frame frame =
      drawn("union(){" + tinted({1, 0, 0}, 0.25, glass) + tinted({0, 0, 1}, 1, box_text({0, 3, -8}, {8, 4, 0})) + "}",
            std::vector<std::string>{});
  CHECK(levels(frame.colour[4 * side + 4]) == glm::dvec3(0, 0, 255));
  CHECK(greatest(levels(frame.colour[side + 1]) - glm::dvec3(64, 0, 191)) <= 1);
}

TEST_CASE("an opaque surface takes precedence over a coincident transparent one") {
  const std::string glass = tinted({1, 0, 0}, 0.5, box_text({0, 0, -8}, {8, 1, 0}));
  const std::string wall = tinted({0, 0, 1}, 1, box_text({0, 0, -8}, {8, 2, 0}));
  for (const std::string& model : {union_of({glass, wall}), union_of({wall, glass})})
    CHECK(levels(drawn(model, std::vector<std::string>{}).colour.front()) == glm::dvec3(0, 0, 255));
}

TEST_CASE("transparent solids do not change depths and owners of opaque surfaces") {
  std::vector<std::string> clear;
  for (const char* const set :
       {"of_colour=0.9,0.2,0.2", "of_colour=0.2,0.8,0.3", "of_colour=0.2,0.3,0.9", "of_colour=0.6,0.1,0.7"}) {
    const std::string rule = fmt::format("materials.{}.", clear.size() / 2);
    clear.push_back(rule + set);
    clear.push_back(rule + "opacity=0");
  }
  const observe::Frame frame = drawn(union_of(parts()), view_of_parts({}));
  const observe::Frame without = drawn(union_of(parts()), view_of_parts(clear));
  const observe::Frame opaque = observe::with_opaque_surfaces(frame);
  CHECK(opaque.depth == without.depth);
  CHECK(opaque.owner == without.owner);
  CHECK(frame.colour != without.colour);
  CHECK(frame.depth != without.depth);
  const std::uint32_t nothing = *std::max_element(opaque.depth.begin(), opaque.depth.end());
  CHECK(std::count(opaque.depth.begin(), opaque.depth.end(), nothing) < 220);
}

TEST_CASE("the order of parts does not change the picture (OpenSCAD issue 1390)") {
  for (const char* const method : {"layers", "screen-door"}) {
    CAPTURE(method);
    const testing::Setup setup = view_of_parts({fmt::format("effects.transparency.method={}", method)});
    std::vector<std::string> all = parts();
    std::sort(all.begin(), all.end());
    const observe::Frame first = drawn(union_of(all), setup);
    CHECK(std::set<std::uint32_t>(first.colour.begin(), first.colour.end()).size() > 5);
    int differing = 0;
    while (std::next_permutation(all.begin(), all.end())) differing += same(drawn(union_of(all), setup), first) ? 0 : 1;
    CHECK(differing == 0);
  }
}

TEST_CASE("a transparent picture is identical on all machines and with all strategies") {
  for (const char* const method : {"layers", "screen-door"}) {
    CAPTURE(method);
    testing::Setup setup = view_of_parts({fmt::format("effects.transparency.method={}", method)});
    setup.memory_bits = 400;
    const observe::Frame first = drawn(union_of(parts()), setup);
    for (const emit::Strategy strategy : emit::strategies) {
      for (const emit::Colouring colouring : emit::colourings) {
        setup.options.strategy = strategy;
        setup.options.colouring = colouring;
        CHECK(same(drawn(union_of(parts()), setup), first));
      }
    }
    setup.options.strategy = emit::Strategy::stack;
    setup.options.colouring = emit::Colouring::rebroadcast;
    setup.has_global_or = false;
    CHECK(same(drawn(union_of(parts()), setup), first));
    setup.kind = &scan_line::kind;
    CHECK(same(drawn(union_of(parts()), setup), first));
    setup.kind = &pixel_square::kind;
    setup.square = {5, 3};
    CHECK(same(drawn(union_of(parts()), setup), first));
  }
}

TEST_CASE("finding colours by owner does not change a transparent picture") {
  static const emit::EffectRow owners{.section = scene::effect_section<NoSettings>("effects.owners", ""),
                                      .technique = "",
                                      .parts = emit::parts_of<AlwaysCalled>,
                                      .needs_owners = true};
  testing::Setup setup = view_of_parts({});
  const observe::Frame first = drawn(union_of(parts()), setup);
  std::vector<const emit::EffectRow*> rows(effects::all().begin(), effects::all().end());
  rows.push_back(&owners);
  setup.options.effects = rows;
  CHECK(same(drawn(union_of(parts()), setup), first));
}

TEST_CASE("an intersection of two glasses has the opacity of each at its own faces") {
  const std::string text = "intersection(){" + tinted({1, 1, 1}, 0.5, box_text({0, 0, -8}, {8, 4, 0})) +
                           tinted({1, 1, 1}, 0.25,
                                  "multmatrix([[0.6,-0.8,0,4],[0.8,0.6,0,0],[0,0,1,-8],[0,0,0,1]]){cube(size=[8,8,8],"
                                  "center=false);}") +
                           "}";
  const observe::Frame frame = drawn(text, std::vector<std::string>{});
  CHECK(greatest(levels(frame.colour[4 * side + 3]) - glm::dvec3(64)) <= 1);
  const observe::Frame turned = drawn(text, {"materials.0.opacity=0.75"});
  CHECK(greatest(levels(turned.colour[4 * side + 3]) - glm::dvec3(191)) <= 1);
}

TEST_CASE("nearly clear panes are not drawn and nearly opaque ones hide what is behind") {
  const std::string clear = tinted({1, 0, 0}, 0.0015, box_text({0, 0, -8}, {8, 1, 0}));
  const std::string dense = tinted({1, 0, 0}, 0.9999, box_text({0, 0, -8}, {8, 1, 0}));
  const std::string wall = tinted({0, 0, 1}, 1, box_text({0, 2, -8}, {8, 3, 0}));
  CHECK(levels(drawn(union_of({clear, wall}), std::vector<std::string>{}).colour.front()) == glm::dvec3(0, 0, 255));
  CHECK(greatest(levels(drawn(union_of({dense, wall}), std::vector<std::string>{}).colour.front()) -
                 glm::dvec3(255, 0, 0)) <= 1.5);
}

TEST_CASE("transparency adds no instruction or field to a scene of opaque solids") {
  const std::string wall = tinted({0, 0, 1}, 1, box_text({0, 2, -8}, {8, 3, 0}));
  const auto none = testing::compile_text(wall, front_view(side, side, scene_of("")));
  const auto called = testing::compile_text(wall, front_view(side, side, scene_of("[effects.transparency]")));
  CHECK(none.program.segments.front().instructions == called.program.segments.front().instructions);
  CHECK(none.program.facts->fields == called.program.facts->fields);
}

TEST_CASE("squares without a transparent surface have no transparency instructions") {
  const std::string wall = tinted({0, 0, 1}, 1, box_text({0, 2, -8}, {8, 3, 0}));
  const std::string pane = tinted({1, 0, 0}, 0.5, box_text({0.5, 0, -3}, {3, 1, -1}));
  testing::Setup setup = front_view(side, side, scene_of(""));
  setup.kind = &pixel_square::kind;
  setup.square = {4, 4};
  const auto with = testing::compile_text(union_of({wall, pane}), setup);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& instructions = with.program.segments[i].instructions;
    const auto charged = std::count_if(instructions.begin(), instructions.end(),
                                       [](const isa::Instruction& one) { return one.origin.effect != isa::no_effect; });
    CHECK((charged > 0) == (i == 0));
  }
}

TEST_CASE("too little memory for transparency is an error that suggests fixes") {
  testing::Setup setup = view_of_parts({});
  setup.memory_bits = 72;
  const std::string message = testing::error_of([&] { (void)testing::compile_text(union_of(parts()), setup); });
  CHECK_MESSAGE(message.find("--set effects.transparency.method=screen-door") != message.npos, message);
  CHECK_MESSAGE(message.find("--set effects.transparency.on=false") != message.npos, message);
  CHECK_MESSAGE(message.find("light let through") != message.npos, message);
  setup.memory_bits = 208;
  CHECK_NOTHROW((void)testing::compile_text(union_of(parts()), setup));
  setup.memory_bits = 72;
  for (const char* const fix : {"effects.transparency.method=screen-door", "effects.transparency.on=false"}) {
    setup.options.scene = scene_of("", {fix});
    CHECK_NOTHROW((void)testing::compile_text(union_of(parts()), setup));
  }
}

TEST_CASE("a screen door of opacity n/16 shows n pixels of each 4 x 4 block") {
  std::set<std::size_t> before;
  for (unsigned pixels = 0; pixels <= effects::max_pattern_pixels; ++pixels) {
    CAPTURE(pixels);
    const std::string pane = tinted({1, 1, 1}, pixels / 16.0, box_text({-1, 0, -9}, {9, 1, 1}));
    const observe::Frame frame = drawn(pane, {"effects.transparency.method=screen-door"});
    std::set<std::size_t> there;
    std::array<unsigned, 4> in_block{};
    for (std::size_t i = 0; i < frame.colour.size(); ++i) {
      if (frame.colour[i] == 0) continue;
      there.insert(i);
      ++in_block.at(i / side / 4 * 2 + i % side / 4);
    }
    CHECK(in_block == std::array<unsigned, 4>{pixels, pixels, pixels, pixels});
    CHECK(std::includes(there.begin(), there.end(), before.begin(), before.end()));
    before = there;
  }
}

TEST_CASE("max_overlap() returns the largest number of rectangles that share a pixel") {
  const bool holds = rc::check("the count equals that of the pixel in most rectangles", [] {
    std::vector<view::PixelRect> all;
    std::array<unsigned, 64> covered{};
    for (int i = *rc::gen::inRange(0, 7); i > 0; --i) {
      const int x = *rc::gen::inRange(0, 8);
      const int y = *rc::gen::inRange(0, 8);
      all.push_back({x, y, *rc::gen::inRange(x, 8), *rc::gen::inRange(y, 8)});
      for (int row = all.back().y0; row <= all.back().y1; ++row)
        for (int column = all.back().x0; column <= all.back().x1; ++column)
          ++covered.at(static_cast<std::size_t>(8 * row + column));
    }
    RC_ASSERT(effects::max_overlap(all) == *std::max_element(covered.begin(), covered.end()));
  });
  CHECK(holds);
}
