#include "sim/report/scale.h"

#include <doctest/doctest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

using namespace csgsim;
using report::Axis;
using report::Scale;

namespace {

std::vector<std::string> texts(const Scale& scale) {
  std::vector<std::string> all;
  for (const report::Tick& tick : scale.ticks()) all.push_back(tick.text);
  return all;
}

}  // namespace

TEST_CASE("a linear axis begins at 0 where that is near, and its ticks are round numbers") {
  const std::vector<double> values{10, 40};
  const Scale scale({"x"}, values, 5);
  CHECK(texts(scale) == std::vector<std::string>{"0", "10", "20", "30", "40"});
  CHECK(scale.at(10) == doctest::Approx(0.25));
}

TEST_CASE("whole numbers have whole ticks") {
  const std::vector<double> values{2, 3};
  CHECK(texts(Scale({"bits"}, values, 8)) == std::vector<std::string>{"2", "3"});
}

TEST_CASE("a logarithmic axis has powers of ten at equal distances") {
  const std::vector<double> values{1, 1000};
  const Scale scale({"x", true}, values, 5);
  CHECK(texts(scale) == std::vector<std::string>{"1", "10", "100", "1,000"});
  CHECK(scale.at(10) == doctest::Approx(1.0 / 3));
}

TEST_CASE("zero stands below the least value of a logarithmic axis") {
  const std::vector<double> values{0, 1, 100};
  const Scale scale({"x", true}, values, 5);
  CHECK(scale.at(0) == 0);
  CHECK(scale.at(1) > 0.1);
  CHECK(scale.at(100) == doctest::Approx(1));
  CHECK(texts(scale).front() == "0");
}

TEST_CASE("words stand beside each other, and some of many have ticks") {
  Axis axis{"x", false, {}};
  for (int i = 0; i < 20; ++i) axis.names.push_back(std::string(1, static_cast<char>('a' + i)));
  const Scale scale(axis, std::vector<double>{}, 5);
  CHECK(scale.ticks().size() == 5);
  CHECK(scale.at(0) == doctest::Approx(0.025));
}

TEST_CASE("every value stands on its axis, and texts of ticks differ") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-9, 12);
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> values(1 + random() % 6);
    const double base = std::pow(10.0, exponent(random));
    for (double& value : values)
      value = random() % 8 == 0 ? 0.0 : base * (1.0 + static_cast<double>(random() % 1000) / 100.0);
    const bool is_logarithmic = random() % 2 == 0;
    const Scale scale({"x", is_logarithmic}, values, 2 + random() % 8);
    for (const double value : values) {
      CHECK(scale.at(value) >= -1e-9);
      CHECK(scale.at(value) <= 1 + 1e-9);
    }
    std::set<std::string> different;
    for (const std::string& text : texts(scale)) different.insert(text);
    CAPTURE(base);
    CHECK(different.size() == scale.ticks().size());
    CHECK(scale.ticks().size() >= 1);
  }
}
