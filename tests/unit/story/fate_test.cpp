#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sim/observe/frame.h"
#include "sim/story/story.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/drawing.h"

using namespace csgsim;
using story::EventKind;
using story::Fate;

namespace {

constexpr std::uint32_t side = 24;

/// Depths that a primitive fills along a pixel's ray, from its planes alone.
struct Interval {
  std::int64_t front = 0;
  std::int64_t back = 0;

  [[nodiscard]] bool holds(std::int64_t z) const { return front <= z && z < back; }
};

Interval interval_of(const testing::Compiled& compiled, std::uint32_t primitive, std::uint32_t x, std::uint32_t y) {
  const view::View& view = compiled.view;
  const view::PixelRect& pixels = view.extents[primitive].pixels;
  const auto column = static_cast<std::int32_t>(x);
  const auto row = static_cast<std::int32_t>(y);
  if (column < pixels.x0 || column > pixels.x1 || row < pixels.y0 || row > pixels.y1) return {};
  Interval all{0, (std::int64_t{1} << view.sampling.z_bits) - 1};
  for (const facet::Halfspace& halfspace : compiled.scene.solids[primitive].halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    const std::int64_t sum = plane.linear.a * column + plane.linear.b * row + plane.linear.c;
    const std::int64_t z = sum >> view.sampling.fraction_bits;
    switch (view::side_of(plane, halfspace)) {
      case view::Side::front: all.front = std::max(all.front, z); break;
      case view::Side::back: all.back = std::min(all.back, z); break;
      case view::Side::edge_positive:
        if (sum < 0) return {};
        break;
      case view::Side::edge_negative:
        if (sum >= 0) return {};
        break;
    }
  }
  return all;
}

/// A pixel evaluated by the rules of the tree.
struct Rules {
  Rules(const testing::Compiled& compiled, std::uint32_t x, std::uint32_t y)
      : tree(compiled.tree), nothing((std::int64_t{1} << compiled.view.sampling.z_bits) - 1) {
    for (std::uint32_t p = 0; p < compiled.tree.primitives.size(); ++p)
      intervals.push_back(interval_of(compiled, p, x, y));
  }

  /// Depth of the primitive's surface, if it has one.
  [[nodiscard]] std::optional<std::int64_t> surface(std::uint32_t p) const {
    const Interval& own = intervals[p];
    if (own.front >= own.back) return std::nullopt;
    return tree.is_subtracted(p) ? own.back : own.front;
  }

  [[nodiscard]] std::vector<bool> primitives_at(std::int64_t z) const {
    std::vector<bool> held;
    for (const Interval& one : intervals) held.push_back(one.holds(z));
    return held;
  }

  testing::TreeRules tree;
  std::int64_t nothing;
  std::vector<Interval> intervals;
};

bool is_merged(Fate fate) { return fate == Fate::covered || fate == Fate::seen; }

/// Checks the fate of each primitive's surface in tree order.
void check_fates(const story::Story& story, const Rules& rules) {
  std::int64_t nearest = rules.nothing;
  for (std::uint32_t p = 0; p < rules.intervals.size(); ++p) {
    CAPTURE(p);
    const auto attempt = std::find_if(story.attempts.begin(), story.attempts.end(),
                                      [p](const story::Attempt& one) { return one.primitive == p; });
    const bool is_told = attempt != story.attempts.end();
    const std::optional<std::int64_t> z = rules.surface(p);
    if (!z || *z >= rules.nothing) {
      if (is_told)
        CHECK((attempt->fate == Fate::outside || attempt->fate == Fate::no_depth || attempt->fate == Fate::behind));
    } else if (*z >= nearest) {
      if (is_told) CHECK(attempt->fate == Fate::behind);
    } else if (!rules.tree.shows(p, rules.primitives_at(*z))) {
      if (is_told) CHECK(attempt->fate == Fate::classified);
    } else {
      REQUIRE(is_told);
      CHECK(is_merged(attempt->fate));
      nearest = *z;
    }
  }
}

/// Whether one compared primitive's state alone hides the surface, whatever the states of the others.
bool decides_alone(const Rules& rules, std::uint32_t primitive, std::uint32_t alone,
                   std::vector<std::uint32_t> compared, std::vector<bool> held) {
  std::erase(compared, alone);
  for (std::uint32_t states = 0; states < 1U << compared.size(); ++states) {
    for (std::size_t i = 0; i < compared.size(); ++i) held[compared[i]] = (states >> i & 1U) != 0;
    if (rules.tree.shows(primitive, held)) return false;
  }
  return true;
}

std::vector<std::uint32_t> compared_with(const isa::Program& program, std::uint32_t primitive) {
  std::vector<std::uint32_t> all;
  for (const isa::Instruction& one : program.segments[0].instructions) {
    const bool compares = one.origin.purpose == isa::Purpose::classify && one.origin.primitive == primitive &&
                          one.origin.node != isa::no_node;
    if (compares && std::find(all.begin(), all.end(), one.origin.node) == all.end()) all.push_back(one.origin.node);
  }
  return all;
}

/// Checks each comparison and each one reported as decisive; returns the number of the latter.
unsigned check_comparisons(const isa::Program& program, const story::Story& story, const Rules& rules) {
  unsigned alone = 0;
  for (const story::Attempt& attempt : story.attempts) {
    const auto& surface = story.events[attempt.first_event].decision;
    if (!surface) continue;
    const std::optional<std::int64_t> z = rules.surface(attempt.primitive);
    for (std::size_t i = attempt.first_event; i <= attempt.last_event; ++i) {
      const story::Event& event = story.events[i];
      if (event.kind != EventKind::comparison) continue;
      REQUIRE(z.has_value());
      CHECK(event.cut.has_value() == !rules.intervals[event.origin.node].holds(*z));
    }
    if (attempt.fate != Fate::classified) continue;
    REQUIRE(z.has_value());
    const std::vector<bool> held = rules.primitives_at(*z);
    CHECK_FALSE(rules.tree.shows(attempt.primitive, held));
    if (!attempt.deciding_comparison) continue;
    const story::Event& comparison = story.events[*attempt.deciding_comparison];
    const std::vector<std::uint32_t> compared = compared_with(program, attempt.primitive);
    if (compared.size() > 10) continue;
    CHECK(decides_alone(rules, attempt.primitive, comparison.origin.node, compared, held));
    ++alone;
  }
  return alone;
}

}  // namespace

TEST_CASE("the story's fate and comparisons of each surface follow the rules of the tree") {
  using emit::Strategy;
  std::minstd_rand random(11);
  unsigned alone = 0;
  std::vector<std::pair<Strategy, unsigned>> all{{Strategy::bits, 4}, {Strategy::bits, 5}, {Strategy::bits, 6}};
  for (const Strategy strategy : emit::default_strategies())
    if (strategy != Strategy::products) all.emplace_back(strategy, emit::min_stack_bits);
  for (const auto& chosen : all) {
    const Strategy strategy = chosen.first;
    const unsigned bits = chosen.second;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      CAPTURE(emit::name_of(strategy));
      CAPTURE(bits);
      CAPTURE(seed);
      testing::Setup setup{{{9, -13.5, 10.5}, {0, 0, 0}, view::Projection::perspective}, {}, 800};
      setup.sampling.width = side;
      setup.sampling.height = side;
      setup.options.strategy = strategy;
      setup.options.stack_bits = bits;
      setup.options.pruning.sets = false;
      setup.options.pruning.hidden = false;
      const testing::Compiled compiled =
          testing::compile_text(testing::random_model(seed, 3 + static_cast<unsigned>(seed % 8)), setup);
      const story::StoryBuilder builder(compiled.program, testing::machine_of(compiled.program.shape));
      for (unsigned pixel = 0; pixel < 12; ++pixel) {
        const std::uint32_t x = static_cast<std::uint32_t>(random()) % side;
        const std::uint32_t y = static_cast<std::uint32_t>(random()) % side;
        CAPTURE(x);
        CAPTURE(y);
        const story::Story story = builder.story_of(x, y);
        const Rules rules(compiled, x, y);
        check_fates(story, rules);
        alone += check_comparisons(compiled.program, story, rules);
      }
    }
  }
  CHECK(alone > 100);
}
