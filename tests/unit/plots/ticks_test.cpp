#include "sim/plots/ticks.h"

#include "sim/plots/extent.h"
#include "sim/plots/number_text.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using Words = std::vector<std::string>;

Words texts(const std::vector<plots::Tick>& ticks) {
  Words words;
  for (const plots::Tick& tick : ticks) words.push_back(tick.text);
  return words;
}

void check_distinct(const std::vector<plots::Tick>& ticks, double low, double high) {
  CAPTURE(low);
  CAPTURE(high);
  std::set<std::string> known;
  for (const plots::Tick& tick : ticks) {
    CHECK(known.insert(tick.text).second);
    CHECK(tick.value >= low - (high - low) * 1e-9);
    CHECK(tick.value <= high + (high - low) * 1e-9);
  }
}

}  // namespace

TEST_CASE("linear ticks are round numbers with enough decimals to be distinct") {
  CHECK(texts(plots::linear_ticks(0, 10, 6)) == Words{"0", "2", "4", "6", "8", "10"});
  CHECK(texts(plots::linear_ticks(275'000, 445'000, 5)) == Words{"300,000", "350,000", "400,000"});
  CHECK(texts(plots::linear_ticks(280'964.8, 280'966.1, 4)) == Words{"280,965.0", "280,965.5", "280,966.0"});
  CHECK(texts(plots::linear_ticks(1.1e6, 1.32e6, 5)) == Words{"1.10 M", "1.15 M", "1.20 M", "1.25 M", "1.30 M"});
  CHECK(texts(plots::linear_ticks(0.00001, 0.00003, 3)) ==
        Words{"10\u00b710\u207b\u2076", "20\u00b710\u207b\u2076", "30\u00b710\u207b\u2076"});
  CHECK(texts(plots::linear_ticks(-0.3, 0.3, 4)) == Words{"-0.2", "0", "0.2"});
}

TEST_CASE("logarithmic ticks are powers of ten or finer in short ranges and sparser in long") {
  CHECK(texts(plots::logarithmic_ticks(0.5, 20'000, 6)) == Words{"1", "10", "100", "1,000", "10,000"});
  CHECK(texts(plots::logarithmic_ticks(3, 130, 6)) == Words{"5", "10", "20", "50", "100"});
  CHECK(texts(plots::logarithmic_ticks(3.05, 3.95, 6)) == Words{"3.2", "3.4", "3.6", "3.8"});
  CHECK(texts(plots::logarithmic_ticks(1e-9, 1e3, 4)) ==
        Words{"10\u207b\u2079", "10\u207b\u2075", "10\u207b\u00b9", "10\u00b3"});
}

TEST_CASE("no two ticks of an axis have the same text for any range") {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  for (int round = 0; round < 20'000; ++round) {
    const auto most = static_cast<unsigned>(3 + random() % 10);
    const double middle = (random() % 2 == 0 ? 1 : -1) * std::pow(10, uniform(-14, 18));
    const double low = random() % 10 == 0 ? 0 : middle;
    const double high = low + std::abs(middle) * std::pow(10, uniform(-13, 3));
    if (!(low < high)) continue;
    const std::vector<plots::Tick> linear = plots::linear_ticks(low, high, most);
    check_distinct(linear, low, high);
    CHECK(linear.size() <= most + 1);
    if (low <= 0) continue;
    const std::vector<plots::Tick> logarithmic = plots::logarithmic_ticks(low, high, most);
    check_distinct(logarithmic, low, high);
    CHECK(logarithmic.size() <= most + 1);
  }
}

TEST_CASE("a linear tick's text equals its value within 1e-9") {
  std::mt19937 random(4);
  for (int round = 0; round < 2'000; ++round) {
    const double low = static_cast<double>(random() % 1'000'000) / 1000 - 500;
    const double high = low + 0.001 + static_cast<double>(random() % 1'000'000) / 1000;
    for (const plots::Tick& tick : plots::linear_ticks(low, high, 8)) {
      std::string digits = tick.text;
      std::erase(digits, ',');
      CHECK(std::stod(digits) == doctest::Approx(tick.value).epsilon(1e-9));
    }
  }
}

TEST_CASE("a logarithmic axis for values from 0 places 0 before the smallest positive value") {
  const std::vector<double> values{0, 3, 40, 5'000};
  const plots::Extent extent = plots::make_extent(values, plots::Scale::by_range, plots::Begin::near_zero);
  CHECK(extent.is_logarithmic);
  CHECK(extent.ticks(8).front() == plots::Tick{0, "0"});
  double before = 0;
  for (const double value : values) {
    CHECK(extent.fraction_along(value) > before);
    before = extent.fraction_along(value);
  }
  CHECK(before < 1);
}

TEST_CASE("an axis is linear for values of one magnitude or a negative value or only zeros") {
  using Values = std::vector<double>;
  CHECK(!plots::make_extent(Values{100, 1'900}, plots::Scale::by_range, plots::Begin::near_zero).is_logarithmic);
  CHECK(plots::make_extent(Values{100, 2'100}, plots::Scale::by_range, plots::Begin::near_zero).is_logarithmic);
  CHECK(
      !plots::make_extent(Values{-1, 100, 10'000}, plots::Scale::logarithmic, plots::Begin::near_zero).is_logarithmic);
  CHECK(!plots::make_extent(Values{0, 0}, plots::Scale::logarithmic, plots::Begin::near_zero).is_logarithmic);
}

TEST_CASE("an axis that must start at 0 does so unless a value is negative") {
  using Values = std::vector<double>;
  for (const Values& values : {Values{21.5, 22.8}, Values{7, 7}, Values{0, 3}, Values{0}}) {
    const plots::Extent extent = plots::make_extent(values, plots::Scale::by_range, plots::Begin::at_zero);
    CHECK(extent.low == 0);
    CHECK(extent.ticks(6).front() == plots::Tick{0, "0"});
    CHECK(extent.fraction_along(values.back()) < 0.96);
  }
  CHECK(plots::make_extent(Values{21.5, 22.8}, plots::Scale::by_range, plots::Begin::near_zero).low > 21);
  CHECK(plots::make_extent(Values{-3, 5}, plots::Scale::by_range, plots::Begin::at_zero).low < -3);
}

TEST_CASE("numbers have four significant digits or from 1000 on grouped whole digits") {
  CHECK(plots::number_text(999.4) == "999.4");
  for (const double value : {999.5, 999.7, 1000.3}) CHECK(plots::number_text(value) == "1,000");
  CHECK(plots::number_text(-999.5) == "-1,000");
  CHECK(plots::number_text(9007199254740991) == "9,007,199,254,740,991");
  CHECK(plots::number_text(1.23456e20) == "1.235e+20");
  CHECK(plots::number_text(-0.0) == "0");
}

TEST_CASE("an axis of whole numbers has whole ticks") {
  using Values = std::vector<double>;
  const plots::Extent extent = plots::make_extent(Values{2, 3}, plots::Scale::linear, plots::Begin::at_values);
  CHECK(texts(extent.ticks(8, true)) == Words{"2", "3"});
  CHECK(texts(plots::logarithmic_ticks(0.4, 150, 6, true)) == Words{"1", "10", "100"});
}

TEST_CASE("values of random axes lie within the axis and its tick texts are distinct") {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> values(1 + random() % 6);
    const double base = std::pow(10.0, static_cast<double>(random() % 21) - 9);
    for (double& value : values)
      value = random() % 8 == 0 ? 0.0 : base * (1.0 + static_cast<double>(random() % 1000) / 100.0);
    const auto scale = static_cast<plots::Scale>(random() % 3);
    const plots::Extent extent = plots::make_extent(values, scale, static_cast<plots::Begin>(random() % 3));
    for (const double value : values) {
      CHECK(extent.fraction_along(value) >= 0);
      CHECK(extent.fraction_along(value) <= 1);
    }
    const Words words = texts(extent.ticks(static_cast<unsigned>(3 + random() % 8)));
    CAPTURE(base);
    CHECK(std::set<std::string>(words.begin(), words.end()).size() == words.size());
    CHECK(words.size() >= 1);
  }
}

TEST_CASE("extreme or equal or missing values get an axis with two or more ticks") {
  using Values = std::vector<double>;
  for (const Values& values :
       {Values{}, Values{0}, Values{7, 7}, Values{-3}, Values{1e-300}, Values{1.7e308, -1.7e308}, Values{1e300}}) {
    for (const plots::Scale scale : {plots::Scale::by_range, plots::Scale::linear, plots::Scale::logarithmic}) {
      CAPTURE(values.size());
      const plots::Extent extent = plots::make_extent(values, scale, plots::Begin::near_zero);
      CHECK(extent.ticks(6).size() >= 2);
      for (const double value : values) {
        CHECK(extent.fraction_along(value) >= 0);
        CHECK(extent.fraction_along(value) <= 1);
      }
    }
  }
}
