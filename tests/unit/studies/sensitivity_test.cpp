// Tests of the arithmetic of csgsim explore --sensitivity: samples, variants, tornados and comparisons.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "sim/studies/sensitivity/comparison.h"
#include "sim/studies/sensitivity/figures.h"
#include "sim/studies/sensitivity/samples.h"
#include "sim/studies/sensitivity/tornado.h"
#include "sim/studies/sensitivity/variants.h"

using namespace csgsim;
using namespace csgsim::studies;

namespace {

const RangedFigure gate_delay{"gate.delay", "ps", 4000, 2000, 8000, "loads", true};
const RangedFigure link_width{"link.width", "bits", 32, 16, 64, "buses", false};
const RangedFigure memory_reads{"memory.reads", "", 1, 1, 2, "ports", false};

const std::optional<double> no_value;

}  // namespace

TEST_CASE("each stratum of a figure has one sample, for any number of samples") {
  for (const std::uint32_t samples : {1U, 2U, 7U, 64U}) {
    std::set<std::uint32_t> hit;
    for (const double position : strata("gate.delay", samples, 1)) {
      CHECK(position >= 0);
      CHECK(position < 1);
      hit.insert(static_cast<std::uint32_t>(position * samples));
    }
    CHECK(hit.size() == samples);
  }
  CHECK(strata("gate.delay", 0, 1).empty());
}

TEST_CASE("samples depend on key and seed and are in no order") {
  const std::vector<double> positions = strata("gate.delay", 64, 1);
  CHECK(positions == strata("gate.delay", 64, 1));
  CHECK(positions != strata("gate.delay", 64, 2));
  CHECK(positions != strata("wire.delay", 64, 1));
  CHECK_FALSE(std::ranges::is_sorted(positions));
  std::vector<std::int64_t> values;
  for (const double position : strata("gate.delay", 4, 1)) values.push_back(value_at(gate_delay, position));
  CHECK(values == std::vector<std::int64_t>{2727, 5193, 3563, 7299});
  const Variants one = make_variants({gate_delay, link_width}, {16, 3});
  const Variants other = make_variants({link_width, gate_delay}, {16, 3});
  for (std::size_t i = 0; i < 16; ++i) {
    Variant turned;
    for (const Setting& setting : one.all[one.samples[i]]) turned.push_back({1 - setting.figure, setting.value});
    std::ranges::reverse(turned);
    CHECK(turned == other.all[other.samples[i]]);
  }
}

TEST_CASE("samples are uniform in the logarithm if high is more than 4 times low") {
  const RangedFigure linear{"a", "", 2, 1, 4, "", false};
  CHECK_FALSE(is_logarithmic(linear));
  std::vector<std::int64_t> values;
  for (const double position : {0.0, 0.24, 0.25, 0.5, 0.999}) values.push_back(value_at(linear, position));
  CHECK(values == std::vector<std::int64_t>{1, 1, 2, 3, 4});

  const RangedFigure logarithmic{"a", "", 10, 10, 999, "", false};
  CHECK(is_logarithmic(logarithmic));
  CHECK(value_at(logarithmic, 0) == 10);
  CHECK(value_at(logarithmic, 0.51) == static_cast<std::int64_t>(10 * std::pow(100, 0.51)));
  CHECK(value_at(logarithmic, 0.99999) == 999);

  CHECK_FALSE(is_logarithmic({"a", "", 0, 0, 9, "", false}));
  CHECK_FALSE(is_logarithmic({"a", "", 2, 2, 8, "", false}));
  CHECK(is_logarithmic({"a", "", 2, 2, 9, "", false}));
}

TEST_CASE("variants set one figure each, then all together, and occur once") {
  const Variants variants = make_variants({gate_delay, link_width, memory_reads}, {});
  CHECK(variants.all == std::vector<Variant>{{}, {{0, 2000}}, {{0, 8000}}, {{1, 16}}, {{1, 64}}, {{2, 2}}});
  CHECK(variants.low == std::vector<std::size_t>{1, 3, 0});
  CHECK(variants.high == std::vector<std::size_t>{2, 4, 5});
  CHECK(name_suffix(variants, {{0, 2000}, {1, 16}}, false) == "+link.width=16");
  CHECK(name_suffix(variants, {{0, 2000}, {1, 16}}, true) == "+gate.delay=2000");
  CHECK(variant_text(variants, {{0, 2000}, {1, 16}}) == "gate.delay=2000, link.width=16");

  const Variants sampled = make_variants({memory_reads}, {8, 1});
  CHECK(sampled.all == std::vector<Variant>{{}, {{0, 2}}});
  CHECK(sampled.samples.size() == 8);
  CHECK(std::ranges::count(sampled.samples, 1U) == 4);
}

TEST_CASE("a tornado has the largest swing first and counts figures without effect") {
  const Variants variants = make_variants({link_width, memory_reads, gate_delay}, {});
  REQUIRE(variants.all.size() == 6);  // stated, width 16, width 64, reads 2, delay 2000, delay 8000
  const std::optional<Tornado> tornado = tornado_of(variants, {10, 10, 10, no_value, 8, 14});
  REQUIRE(tornado);
  CHECK(tornado->base == 10);
  CHECK(tornado->effects == std::vector<FigureEffect>{{2, 8, 14, 6}, {0, 10, 10, 0}, {1, 10, no_value, 0}});
  CHECK(without_effect(*tornado) == 1);
  CHECK(span_of(*tornado).low == 8);
  CHECK(span_of(*tornado).high == 14);
  CHECK_FALSE(tornado->samples);
  CHECK_FALSE(tornado_of(variants, {no_value, 1, 1, 1, 1, 1}));
}

TEST_CASE("percentiles are interpolated, and samples without a value are not counted") {
  std::vector<double> values;
  for (int i = 21; i > 0; --i) values.push_back(i);
  CHECK(percentiles_of(values) == Percentiles{21, 2, 11, 20});
  CHECK(percentiles_of({1, 2}) == Percentiles{2, 1.05, 1.5, 1.95});
  CHECK_FALSE(percentiles_of({}));

  Variants variants = make_variants({memory_reads}, {});
  variants.samples = {0, 1, 1};
  CHECK(tornado_of(variants, {4, no_value})->samples == Percentiles{1, 4, 4, 4});
  CHECK(tornado_of(variants, {4, 8})->samples->p50 == 8);
}

TEST_CASE("a comparison names the figures that change its sign") {
  Variants variants = make_variants({gate_delay, link_width, memory_reads}, {});
  variants.samples = {0, 1, 4, 5};
  const VariantValues reference{10, 8, 14, 10, 10, no_value};
  const VariantValues design{9, 9, 9, 9, 10, 5};
  const std::optional<Comparison> comparison = compare(variants, reference, design);
  REQUIRE(comparison);
  CHECK(comparison->ratio.base == 0.9);
  CHECK(span_of(comparison->ratio).low == doctest::Approx(9.0 / 14));
  CHECK(span_of(comparison->ratio).high == 9.0 / 8);
  CHECK(comparison->sign == Changes{{{0, 2000}, {1, 64}}, 2});
  CHECK(comparison->ratio.samples->samples == 3);

  // Rounding errors are no difference.
  CHECK(compare(variants, {1, 1, 1, 1, 1, 1}, {1, 1 + 1e-12, 1 - 1e-12, 1, 1, 1})->sign == Changes{});
  CHECK_FALSE(compare(variants, {0, 1, 1, 1, 1, 1}, design));
}

TEST_CASE("a ranking changes if the order of any two designs does") {
  const Variants variants = make_variants({gate_delay, link_width, memory_reads}, {});
  const std::vector<VariantValues> designs{{1, 1, 1, 1, 3, 1}, {2, 2, 2, 2, 2, no_value}, {3, 3, 1.5, 3, 1, no_value}};
  CHECK(ranking_changes(variants, designs) == Changes{{{0, 8000}, {1, 64}}, 0});
  CHECK(ranking_changes(variants, std::vector<VariantValues>{designs[0], designs[1]}) == Changes{{{1, 64}}, 0});
}
