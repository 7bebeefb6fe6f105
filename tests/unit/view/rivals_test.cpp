#include "host/view/rivals.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;
using namespace view;
using Numbers = std::vector<std::uint32_t>;

namespace {

std::int64_t between(std::int64_t low, std::int64_t high) { return *rc::gen::inRange<std::int64_t>(low, high + 1); }

/// Functions that are nearly equal or cross in many ways.
std::vector<FixedLinear> random_functions(std::size_t count, const view::PixelRect& rect) {
  const int kind = *rc::gen::inRange(0, 7);
  const std::int64_t slope = *rc::gen::element<std::int64_t>(1, 9, 300, std::int64_t{1} << 30U);
  const FixedLinear base{between(-slope, slope), between(-slope, slope), between(-20 * slope, 20 * slope)};
  const FixedLinear edge{between(-5, 5), between(-5, 5), between(-60, 60)};
  std::vector<FixedLinear> made;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t x = between(2 * rect.x0 - rect.x1, 2 * rect.x1 - rect.x0);
    const std::int64_t y = between(2 * rect.y0 - rect.y1, 2 * rect.y1 - rect.y0);
    const std::int64_t times = between(-slope, slope);
    switch (kind) {
      case 0: made.push_back({between(-slope, slope), between(-slope, slope), between(-20 * slope, 20 * slope)}); break;
      // Tangents of a bowl.
      case 1: made.push_back({2 * slope * x, 2 * slope * y, -slope * (x * x + y * y)}); break;
      // Planes through one edge.
      case 2: made.push_back({base.a + times * edge.a, base.b + times * edge.b, base.c + times * edge.c}); break;
      case 3: made.push_back(base); break;
      case 4: made.push_back({0, 0, between(-slope, slope)}); break;
      case 5: made.push_back({base.a, base.b, base.c + between(-2, 2)}); break;
      // Slivers: nearly parallel and steep.
      default: made.push_back({base.a + between(-1, 1), base.b + between(-1, 1), base.c + between(-30, 30)});
    }
  }
  return made;
}

struct Drawn {
  Boundary boundary;
  view::PixelRect rect;
  unsigned shift = 0;
};

/// Moves backs and edges so that the solid exists at a pixel, sometimes only just.
void open_at(Drawn& drawn, std::int64_t x, std::int64_t y) {
  Boundary& boundary = drawn.boundary;
  const auto value = [&](const FixedLinear& one) { return one.a * x + one.b * y + one.c; };
  for (FixedLinear& one : boundary.edges) one.c += between(0, 9) - value(one);
  if (boundary.fronts.empty() || boundary.backs.empty()) return;
  const std::int64_t begins = value(std::ranges::max(boundary.fronts, {}, value));
  const std::int64_t ends = value(std::ranges::min(boundary.backs, {}, value));
  const std::int64_t thickness =
      *rc::gen::element<std::int64_t>(0, 1, 9, 5000, std::int64_t{1} << 20U, std::int64_t{1} << 36U);
  for (FixedLinear& one : boundary.backs) one.c += begins - ends + thickness;
}

Drawn random_drawn() {
  Drawn drawn;
  const std::int32_t size = *rc::gen::element(0, 1, 3, 12, 30);
  const std::int32_t x = *rc::gen::inRange(-40, 40);
  const std::int32_t y = *rc::gen::inRange(-40, 40);
  drawn.rect = {x, y, x + *rc::gen::inRange(0, size + 1), y + *rc::gen::inRange(0, size + 1)};
  drawn.shift = *rc::gen::element(0U, 3U, 12U);
  Boundary& boundary = drawn.boundary;
  boundary.fronts = random_functions(*rc::gen::element<std::size_t>(0, 1, 5, 17, 70), drawn.rect);
  boundary.backs = random_functions(*rc::gen::element<std::size_t>(0, 1, 5, 17, 70), drawn.rect);
  boundary.edges = random_functions(*rc::gen::element<std::size_t>(0, 0, 2, 20), drawn.rect);
  for (FixedLinear& one : boundary.backs) one = {-one.a, -one.b, -one.c};
  if (between(0, 3) > 0) open_at(drawn, between(x, drawn.rect.x1), between(y, drawn.rect.y1));
  return drawn;
}

Numbers all_of(const std::vector<FixedLinear>& functions) {
  Numbers numbers(functions.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// Values of a boundary at one pixel in plain integers.
struct AtPixel {
  std::int32_t x;
  std::int32_t y;
  std::vector<std::int64_t> fronts;
  std::vector<std::int64_t> backs;
  std::vector<bool> edges;

  AtPixel(const Drawn& drawn, std::int32_t column, std::int32_t row) : x(column), y(row) {
    const auto value = [&](const FixedLinear& one) { return one.a * x + one.b * y + one.c; };
    const std::int64_t step = std::int64_t{1} << drawn.shift;
    const auto depth = [&](const FixedLinear& one) {
      const std::int64_t quotient = value(one) / step;
      return value(one) < quotient * step ? quotient - 1 : quotient;
    };
    for (const FixedLinear& one : drawn.boundary.fronts) fronts.push_back(depth(one));
    for (const FixedLinear& one : drawn.boundary.backs) backs.push_back(depth(one));
    for (const FixedLinear& one : drawn.boundary.edges) edges.push_back(value(one) >= 0);
  }

  [[nodiscard]] bool is_front(std::uint32_t one, const view::Rivals& among) const {
    for (const std::uint32_t i : among.fronts)
      if (i < one ? fronts[i] >= fronts[one] : fronts[i] > fronts[one]) return false;
    for (const std::uint32_t i : among.backs)
      if (backs[i] <= fronts[one]) return false;
    return std::ranges::all_of(among.edges, [&](std::uint32_t i) { return edges[i]; });
  }
  [[nodiscard]] bool is_back(std::uint32_t one, const view::Rivals& among) const {
    for (const std::uint32_t i : among.backs)
      if (i < one ? backs[i] <= backs[one] : backs[i] < backs[one]) return false;
    for (const std::uint32_t i : among.fronts)
      if (fronts[i] >= backs[one]) return false;
    return std::ranges::all_of(among.edges, [&](std::uint32_t i) { return edges[i]; });
  }
};

bool is_ascending(const Numbers& numbers, std::size_t below) {
  return std::ranges::adjacent_find(numbers, std::greater_equal()) == numbers.end() &&
         (numbers.empty() || numbers.back() < below);
}

void require_numbers(const view::Rivals& rivals, const Boundary& boundary) {
  RC_ASSERT(is_ascending(rivals.fronts, boundary.fronts.size()));
  RC_ASSERT(is_ascending(rivals.backs, boundary.backs.size()));
  RC_ASSERT(is_ascending(rivals.edges, boundary.edges.size()));
}

struct Tally {
  std::uint64_t leads = 0;
  std::uint64_t left_out = 0;
};

bool holds(const view::PixelRect& rect, const AtPixel& at) {
  return at.x >= rect.x0 && at.x <= rect.x1 && at.y >= rect.y0 && at.y <= rect.y1;
}

void require_ends(const AtPixel& at, const view::AllRivals& found, const view::Rivals& all, Tally& tally) {
  const auto depth_in = [](const std::vector<std::int64_t>& depths) {
    return [&depths](std::uint32_t i) { return depths[i]; };
  };
  for (const std::uint32_t i : all.fronts) {
    const view::Rivals& rivals = found.of_fronts[i];
    RC_ASSERT(at.is_front(i, rivals) == at.is_front(i, all));
    if (!at.is_front(i, all) || at.backs.empty()) continue;
    ++tally.leads;
    RC_ASSERT(holds(rivals.pixels, at));
    RC_ASSERT(!rivals.backs.empty());
    RC_ASSERT(at.backs[std::ranges::min(rivals.backs, {}, depth_in(at.backs))] == std::ranges::min(at.backs));
  }
  for (const std::uint32_t i : all.backs) {
    const view::Rivals& rivals = found.of_backs[i];
    RC_ASSERT(at.is_back(i, rivals) == at.is_back(i, all));
    if (!at.is_back(i, all) || at.fronts.empty()) continue;
    RC_ASSERT(holds(rivals.pixels, at));
    RC_ASSERT(!rivals.fronts.empty());
    RC_ASSERT(at.fronts[std::ranges::max(rivals.fronts, {}, depth_in(at.fronts))] == std::ranges::max(at.fronts));
  }
}

void require_sufficient_rivals(const Drawn& drawn, Tally& tally) {
  const Boundary& boundary = drawn.boundary;
  const view::Rivals all{all_of(boundary.fronts), all_of(boundary.backs), all_of(boundary.edges)};
  const view::AllRivals found = view::rivals(boundary, drawn.rect, drawn.shift);
  RC_ASSERT(found.of_fronts.size() == boundary.fronts.size());
  RC_ASSERT(found.of_backs.size() == boundary.backs.size());
  for (const auto* const side : {&found.of_fronts, &found.of_backs}) {
    for (const view::Rivals& rivals : *side) {
      require_numbers(rivals, boundary);
      tally.left_out += all.fronts.size() + all.backs.size() - rivals.fronts.size() - rivals.backs.size();
    }
  }
  for (std::int32_t y = drawn.rect.y0; y <= drawn.rect.y1; ++y)
    for (std::int32_t x = drawn.rect.x0; x <= drawn.rect.x1; ++x) require_ends(AtPixel(drawn, x, y), found, all, tally);
}

/// Planes tangent to a bowl, side * side of them.
Boundary bowl(std::int64_t side, std::int32_t width) {
  Boundary boundary;
  for (std::int64_t i = 0; i < side; ++i) {
    for (std::int64_t j = 0; j < side; ++j) {
      const std::int64_t x = (2 * i + 1) * width * 512 / side;
      const std::int64_t y = (2 * j + 1) * width * 512 / side;
      boundary.fronts.push_back({2048 * x, 2048 * y, -(x * x + y * y)});
    }
  }
  boundary.backs.push_back({0, 0, std::int64_t{1} << 50U});
  return boundary;
}

}  // namespace

TEST_CASE("rivals include each boundary at which a solid begins or ends in hard cases") {
  Tally tally;
  CHECK(rc::check([&] {
    for (int i = 0; i < 10; ++i) require_sufficient_rivals(random_drawn(), tally);
  }));
  MESSAGE(tally.leads, " pixels with a front, ", tally.left_out, " left out");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.leads > 500);
  CHECK(tally.left_out > 100'000);
}

TEST_CASE("each of many faces spread over the picture has under 60 rivals on average") {
  for (const std::int64_t side : {10, 50, 200}) {
    CAPTURE(side);
    const Boundary boundary = bowl(side, 1024);
    const view::AllRivals found = view::rivals(boundary, {0, 0, 1023, 1023}, 0);
    std::uint64_t sum = 0;
    for (const view::Rivals& rivals : found.of_fronts) sum += rivals.fronts.size();
    CHECK(sum < static_cast<std::uint64_t>(60 * side * side));
  }
}

TEST_CASE("a few boundary functions are all rivals of each other if there are pixels") {
  const Boundary boundary = bowl(3, 64);
  const view::AllRivals found = view::rivals(boundary, {0, 0, 63, 63}, 0);
  CHECK(found.of_fronts[4].fronts == Numbers{0, 1, 2, 3, 5, 6, 7, 8});
  CHECK(found.of_fronts[4].backs == Numbers{0});
  CHECK(found.of_backs[0].fronts.size() == 9);
  const view::AllRivals nowhere = view::rivals(boundary, {}, 0);
  CHECK(nowhere.of_fronts.size() == 9);
  CHECK(nowhere.of_fronts[4].fronts.empty());
}
