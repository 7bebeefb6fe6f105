#include <rapidcheck.h>

#include "hw/array/linear_evaluator.h"
#include "tests/support/test.h"

namespace {

using csgsim::array::LinearEvaluator;
using csgsim::array::low_bits;
using csgsim::array::PlaneShape;
using csgsim::array::RootBits;
using csgsim::array::StreamBit;
using csgsim::array::TreeForm;

struct Expression {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
  std::int64_t xx = 0;
  std::int64_t xy = 0;
  std::int64_t yy = 0;
  unsigned width = 1;
  unsigned idle_after = 0;  ///< number of clocks
};

/// The root bits of each clock, at most `width` bits.
std::vector<RootBits> stream(const std::vector<Expression>& expressions, unsigned width) {
  std::vector<RootBits> bits;
  for (const Expression& e : expressions) {
    for (unsigned j = 0; j < e.width; j += width) {
      const unsigned count = std::min(width, e.width - j);
      const auto of = [&](std::int64_t coefficient) {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(coefficient) >> j & low_bits(count));
      };
      bits.push_back({.token = {.bit = static_cast<std::int16_t>(j), .bits = static_cast<std::uint16_t>(count)},
                      .a = of(e.a),
                      .b = of(e.b),
                      .c = of(e.c),
                      .xx = of(e.xx),
                      .xy = of(e.xy),
                      .yy = of(e.yy)});
    }
    bits.resize(bits.size() + e.idle_after);
  }
  return bits;
}

/// The sum of six products modulo 2^64; its low `width` bits are those of F.
std::uint64_t value(const Expression& e, std::uint32_t x, std::uint32_t y) {
  const auto squares = static_cast<std::uint64_t>(e.xx) * x * x + static_cast<std::uint64_t>(e.xy) * x * y +
                       static_cast<std::uint64_t>(e.yy) * y * y;
  return squares + static_cast<std::uint64_t>(e.a) * x + static_cast<std::uint64_t>(e.b) * y +
         static_cast<std::uint64_t>(e.c);
}

/// Streams the expressions and collects the values that arrive at every pixel: one per expression, in pixel order.
std::vector<std::vector<std::uint64_t>> evaluate(PlaneShape shape, const std::vector<Expression>& expressions,
                                                 TreeForm form) {
  LinearEvaluator evaluator(shape, form.register_levels);
  StreamBit leaves;
  std::vector<std::vector<std::uint64_t>> values;
  std::vector<RootBits> bits = stream(expressions, form.bits);
  bits.resize(bits.size() + evaluator.latency());
  const unsigned registers = evaluator.latency();  // the leaves are the registers of the last level
  for (std::size_t clock = 0; clock < bits.size(); ++clock) {
    const bool reached = evaluator.clock(bits[clock], leaves);
    const std::size_t sent =
        clock + 1 - registers;  // index of the bits that have passed `registers` registers after this clock
    if (registers > clock + 1) {
      CHECK_FALSE(reached);
      continue;
    }
    const RootBits& root = registers == 0 ? bits[clock] : bits[sent];
    CHECK(reached == root.token.active());
    if (!reached) continue;
    if (root.token.bit == 0) values.emplace_back(std::size_t{shape.width} * shape.height);
    for (std::uint32_t y = 0; y < shape.height; ++y) {
      for (std::uint32_t x = 0; x < shape.width; ++x) {
        const std::uint64_t bits_here = leaves.at({x, y});
        values.back()[std::size_t{y} * shape.width + x] |= bits_here << root.token.bit;
      }
    }
  }
  return values;
}

void check_against_integers(PlaneShape shape, const std::vector<Expression>& expressions, TreeForm form = {}) {
  const auto values = evaluate(shape, expressions, form);
  RC_ASSERT(values.size() == expressions.size());
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    for (std::uint32_t y = 0; y < shape.height; ++y) {
      for (std::uint32_t x = 0; x < shape.width; ++x) {
        const std::uint64_t expected = value(expressions[i], x, y) & low_bits(expressions[i].width);
        RC_ASSERT(values[i][std::size_t{y} * shape.width + x] == expected);
      }
    }
  }
}

rc::Gen<std::int64_t> coefficient() {
  return rc::gen::map(
      rc::gen::pair(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int64_t>()), rc::gen::inRange(0, 64)),
      [](const auto& pair) { return pair.first >> pair.second; });
}

std::vector<Expression> some_expressions() {
  std::vector<Expression> expressions(*rc::gen::inRange<std::size_t>(1, 8));
  for (Expression& e : expressions) {
    e = {.a = *coefficient(), .b = *coefficient(), .c = *coefficient(), .width = *rc::gen::inRange(1U, 63U)};
    if (*rc::gen::inRange(0, 2) == 0) {
      e.xx = *coefficient();
      e.xy = *coefficient();
      e.yy = *coefficient();
    }
    if (*rc::gen::inRange(0, 3) == 0) e.idle_after = *rc::gen::inRange(0U, 30U);
  }
  return expressions;
}

constexpr PlaneShape shapes[] = {{1, 1},   {2, 1},   {1, 2},   {3, 1},  {1, 5},    {7, 7},    {8, 8},
                                 {9, 8},   {16, 16}, {33, 7},  {64, 1}, {64, 64},  {65, 3},   {127, 2},
                                 {128, 4}, {129, 5}, {300, 9}, {5, 67}, {512, 16}, {640, 11}, {1025, 2}};

}  // namespace

TEST_CASE("back-to-back streams of any width give sums modulo 2^width at every pixel") {
  for (const PlaneShape shape : shapes) {
    CAPTURE(shape.width);
    CAPTURE(shape.height);
    CHECK(rc::check([shape] { check_against_integers(shape, some_expressions()); }));
  }
}

TEST_CASE("trees with several bits per clock or fewer registers give the same sums") {
  for (const PlaneShape shape : shapes) {
    CAPTURE(shape.width);
    CAPTURE(shape.height);
    CHECK(rc::check([shape] {
      const TreeForm form{2, *rc::gen::inRange(1U, 33U), *rc::gen::inRange(1U, 17U)};
      check_against_integers(shape, some_expressions(), form);
    }));
  }
}

TEST_CASE("streams of one bit may follow each other in every clock") {
  std::vector<Expression> expressions;
  for (int i = 0; i < 100; ++i) expressions.push_back({.a = i & 1, .b = i >> 1, .c = i >> 2, .width = 1});
  CHECK(rc::check([&] { check_against_integers({33, 9}, expressions); }));
}

TEST_CASE("the trees' latency is ceil(log2 W) + ceil(log2 H) clocks") {
  CHECK(LinearEvaluator({1, 1}).latency() == 0);
  CHECK(LinearEvaluator({2, 1}).latency() == 1);
  CHECK(LinearEvaluator({1, 3}).latency() == 2);
  CHECK(LinearEvaluator({33, 7}).latency() == 9);
  CHECK(LinearEvaluator({512, 512}).latency() == 18);
}

TEST_CASE("the first bit reaches the pixels exactly `latency` clocks after it enters") {
  const PlaneShape shape{512, 512};
  LinearEvaluator evaluator(shape);
  StreamBit leaves;
  const RootBits one{.token = {.bit = 0}, .c = true};
  for (unsigned clock = 1; clock < evaluator.latency(); ++clock) {
    CHECK_FALSE(evaluator.clock(clock == 1 ? one : RootBits{}, leaves));
    CHECK_FALSE(leaves.at({511, 511}));
  }
  CHECK(evaluator.clock({}, leaves));
  CHECK(leaves.at({511, 511}));
  CHECK_FALSE(evaluator.clock({}, leaves));
}

TEST_CASE("clearing the trees discards streams in flight") {
  LinearEvaluator evaluator({8, 8});
  StreamBit leaves;
  evaluator.clock({.token = {.bit = 0}, .c = true}, leaves);
  evaluator.clear();
  for (int clock = 0; clock < 10; ++clock) CHECK_FALSE(evaluator.clock({}, leaves));
}
