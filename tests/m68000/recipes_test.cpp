// The prices of the host's most expensive recipes, compared with assembly on an MC68000.

#include "hw/host/recipes.h"

#include "hw/host/node_recipes.h"
#include "hw/processors/processor.h"
#include "tests/m68000/processor.h"
#include "tests/support/test.h"

using namespace csgsim;
using m68000::Size;

namespace tasks_by_hand {
#include "tests/m68000/programs.inc"
}

namespace {

/// Tolerance of a recipe's clocks, relative to those of the assembly: the recipes price multiplications at their
/// maximum, and do not count signs, addresses of table entries, and the search for a divisor's first digit.
constexpr double most_off = 0.2;

constexpr std::uint32_t program_at = 0x1000;
constexpr std::uint32_t stack_at = 0x4000;
constexpr std::uint32_t operands_at = 0x5000;  ///< a0
constexpr std::uint32_t others_at = 0x5100;    ///< a1
constexpr std::uint32_t results_at = 0x5200;   ///< a2
constexpr std::uint32_t tables_at = 0x5300;    ///< entries of components
constexpr std::uint64_t rts_clocks = 16;       ///< not part of a recipe
constexpr unsigned long_bits = 32;
constexpr std::int32_t unit = 1 << 12;       ///< a slope of 1
constexpr std::int32_t edge_limit = 8192;    ///< divisors below make edge tests
constexpr std::uint32_t sign = 0x8000'0000;  ///< of a component, in the address of its entry

using Numbers = std::vector<std::int32_t>;

/// Operands with up to 28 bits, as those of the host, so that sums of products do not overflow.
class Random {
 public:
  std::int32_t number() { return static_cast<std::int32_t>(next()) >> 3; }
  std::int32_t positive() { return number() & 0x0fff'ffff; }
  /// A number of any size: 13 to 28 bits are equally frequent.
  std::int32_t of_any_size() { return number() >> (positive() % 16); }
  Numbers numbers(std::size_t count) {
    Numbers all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(number());
    return all;
  }

 private:
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state_ >> 32U);
  }

  std::uint64_t state_ = 1;
};

class Task {
 public:
  Task() : processor_(0x10000) {
    std::uint32_t at = program_at;
    for (const std::uint16_t word : tasks_by_hand::words) {
      processor_.write(at, Size::word, word);
      at += 2;
    }
    processor_.a = {operands_at, others_at, results_at, 0, 0, 0, 0, stack_at};
  }

  void write(std::uint32_t at, const Numbers& longs) {
    for (const std::int32_t number : longs) {
      processor_.write(at, Size::longword, static_cast<std::uint32_t>(number));
      at += 4;
    }
  }
  void write_words(std::uint32_t at, const Numbers& words) {
    for (const std::int32_t number : words) {
      processor_.write(at, Size::word, static_cast<std::uint32_t>(number) & 0xffffU);
      at += 2;
    }
  }
  /// The three address registers that hold a direction.
  void set_direction(const Numbers& direction) {
    for (std::size_t i = 0; i < 3; ++i) processor_.a[4 + i] = static_cast<std::uint32_t>(direction[i]);
  }
  void set(unsigned reg, std::int32_t value) { processor_.d[reg] = static_cast<std::uint32_t>(value); }

  /// Calls the subroutine and returns its clocks.
  std::uint64_t run(std::uint32_t at) {
    processor_.call(at, 10'000);
    return processor_.clocks() - rts_clocks;
  }

  [[nodiscard]] std::int32_t word(std::uint32_t at) const {
    return static_cast<std::int16_t>(processor_.read(at, Size::word));
  }
  [[nodiscard]] std::int32_t data(unsigned reg) const { return static_cast<std::int32_t>(processor_.d[reg]); }
  [[nodiscard]] Numbers longs(std::uint32_t at, unsigned count) const {
    Numbers all;
    for (unsigned i = 0; i < count; ++i)
      all.push_back(static_cast<std::int32_t>(processor_.read(at + 4 * i, Size::longword)));
    return all;
  }

 private:
  m68000::Processor processor_;
};

std::int32_t product(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> long_bits);
}

/// The sum of products of the first `count` numbers.
std::int32_t sum(const Numbers& a, std::span<const std::int32_t> b) {
  std::int32_t all = 0;
  for (std::size_t i = 0; i < a.size(); ++i) all += product(a[i], b[i]);
  return all;
}

/// Three components in random directions along their axes, with the numbers of their entries in the tables.
class Components {
 public:
  Components(Random& random, std::size_t numbers) : numbers_(numbers) {
    for (std::size_t axis = 0; axis < axes; ++axis) is_negative_.push_back(random.number() < 0);
    for (std::size_t i = 0; i < axes * numbers; ++i) entries_.push_back(random.of_any_size());
  }

  /// Writes the entries to the tables and returns the components as the assembly reads them.
  [[nodiscard]] Numbers write(Task& task) const {
    task.write(tables_at, entries_);
    Numbers components;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto address = static_cast<std::uint32_t>(tables_at + 4 * numbers_ * axis);
      components.push_back(static_cast<std::int32_t>(is_negative_[axis] ? address | sign : address));
    }
    return components;
  }

  /// The signed sum of the three entries' numbers at that place.
  [[nodiscard]] std::int32_t sum(std::size_t place) const {
    std::int32_t all = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::int32_t number = entries_[numbers_ * axis + place];
      all += is_negative_[axis] ? -number : number;
    }
    return all;
  }

 private:
  static constexpr std::size_t axes = 3;
  std::size_t numbers_;
  std::vector<bool> is_negative_;
  Numbers entries_;
};

/// A reciprocal with 30 significant bits, and the places that a product by it is shifted back to a slope.
struct Reciprocal {
  std::int32_t factor = 0;
  std::int32_t places = 0;

  explicit Reciprocal(std::int32_t divisor) {
    if (std::abs(divisor) < edge_limit) return;
    const int shift = std::countl_zero(static_cast<std::uint32_t>(std::abs(divisor))) - 1;
    factor = static_cast<std::int32_t>(((std::int64_t{1} << 61) - 1) / (std::int64_t{std::abs(divisor)} << shift));
    if (divisor < 0) factor = -factor;
    places = 17 - shift;
  }

  [[nodiscard]] std::int32_t times(std::int32_t dividend) const {
    return factor == 0 ? dividend : product(dividend, factor) >> places;
  }
};

/// Checks that a slope is the quotient, less than two units off, or the dividend of an edge test.
void check_slope(std::int32_t slope, std::int32_t dividend, std::int32_t divisor) {
  if (std::abs(divisor) < edge_limit) {
    CHECK(slope == dividend);
  } else {
    CHECK(std::abs(slope - static_cast<double>(dividend) * unit / divisor) < 2);
  }
}

constexpr int runs = 200;

/// Compares the mean clocks of a task with its recipe at the prices of the processor file.
void check(const char* name, const processors::Operations& recipe, double mean) {
  const auto clocks =
      static_cast<double>(processors::hand_written_clocks(recipe, processors::built_in_processor("mc68000")));
  const double ratio = clocks / mean;
  MESSAGE(fmt::format("{}: {} clocks by the recipe, {:.0f} by assembly, {:.3f}", name, clocks, mean, ratio));
  CHECK(ratio > 1 - most_off);
  CHECK(ratio < 1 + most_off);
}
void check(const char* name, double mean) { check(name, host::recipe(name), mean); }

}  // namespace

TEST_CASE("the tasks in assembly are the five with the most expensive recipes") {
  std::vector<std::pair<std::uint64_t, std::string_view>> prices;
  for (const host::Recipe& one : host::recipes())
    prices.emplace_back(processors::hand_written_clocks(one.each, processors::built_in_processor("mc68000")), one.name);
  std::ranges::sort(prices, std::greater());
  prices.resize(5);
  std::vector<std::string_view> names;
  for (const auto& [price, name] : prices) names.push_back(name);
  CHECK(names == std::vector<std::string_view>{"quotients", "colours", "supports", "tests", "planes"});
}

TEST_CASE("the recipe of quotients has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int done = 0; done < runs;) {
    const Components direction(random, 3);
    const Numbers sums{direction.sum(0), direction.sum(1), direction.sum(2)};
    Task task;
    task.write(operands_at, direction.write(task));
    const std::uint64_t taken = task.run(tasks_by_hand::quotient_at);
    const Reciprocal expected(sums[2]);
    CHECK(task.longs(results_at, 1) == Numbers{expected.factor});
    CHECK(task.word(results_at + 4) == expected.places);
    const Numbers slopes = task.longs(results_at + 6, 2);
    CHECK(slopes == Numbers{expected.times(sums[0]), expected.times(sums[1])});
    check_slope(slopes[0], sums[0], sums[2]);
    check_slope(slopes[1], sums[1], sums[2]);
    if (expected.factor == 0) continue;
    clocks += static_cast<double>(taken);
    ++done;
  }
  check("quotients", clocks / runs);
}

TEST_CASE("the recipe of planes has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int done = 0; done < runs;) {
    const Components normal(random, 4);
    const std::int32_t offset = random.of_any_size();
    const std::int32_t divisor = random.of_any_size();
    const Reciprocal reciprocal(divisor);
    Task task;
    Numbers plane = normal.write(task);
    plane.insert(plane.begin(), offset);
    plane.push_back(static_cast<std::int32_t>(others_at));
    task.write(operands_at, plane);
    task.write(others_at, {reciprocal.factor});
    task.write_words(others_at + 4, {reciprocal.places});
    const std::uint64_t taken = task.run(tasks_by_hand::plane_at);
    const std::int32_t moved = offset + normal.sum(3);
    const std::int32_t result = task.longs(results_at, 1).front();
    CHECK(result == reciprocal.times(moved));
    check_slope(result, moved, divisor);
    if (reciprocal.factor == 0) continue;
    clocks += static_cast<double>(taken);
    ++done;
  }
  check("planes", clocks / runs);
}

TEST_CASE("the recipe of a plane without tables has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int done = 0; done < runs;) {
    const Numbers normal = random.numbers(3);
    const Numbers rows = random.numbers(12);
    const std::int32_t offset = random.of_any_size();
    const auto row = [&](std::size_t i) { return sum(normal, std::span(rows).subspan(3 * i, 3)); };
    Task task;
    task.write(operands_at, {offset});
    task.write(operands_at + 4, rows);
    task.set_direction(normal);
    const std::uint64_t taken = task.run(tasks_by_hand::own_plane_at);
    const Reciprocal expected(row(3));
    CHECK(task.longs(results_at, 1) == Numbers{expected.factor});
    CHECK(task.word(results_at + 4) == expected.places);
    const Numbers dividends{row(1), row(2), offset + row(0)};
    const Numbers results = task.longs(results_at + 6, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(results[i] == expected.times(dividends[i]));
      check_slope(results[i], dividends[i], row(3));
    }
    if (expected.factor == 0) continue;
    clocks += static_cast<double>(taken);
    ++done;
  }
  check("a plane without tables", host::plane_transform_operations(), clocks / runs);
}

TEST_CASE("the recipe of colours has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int i = 0; i < runs; ++i) {
    const Numbers normal = random.numbers(3);
    const Numbers light = random.numbers(3);
    const Numbers surface{random.positive() >> 7, random.positive() >> 7, random.positive() >> 7};
    Task task;
    task.write(operands_at, normal);
    task.write(others_at, surface);
    task.set_direction(light);
    clocks += static_cast<double>(task.run(tasks_by_hand::colour_at));
    const std::int32_t arrived = std::max(0, sum(normal, light));
    std::int32_t colour = 0;
    for (const std::int32_t channel : surface) colour = colour * 256 + std::min(255, product(arrived, channel));
    CHECK(task.data(6) == colour);
  }
  check("colours", clocks / runs);
}

TEST_CASE("the recipe of support points has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int i = 0; i < runs; ++i) {
    const Numbers point = random.numbers(3);
    const Numbers direction = random.numbers(3);
    const std::int32_t farthest = random.number() / 32;
    Task task;
    task.write(operands_at, point);
    task.set_direction(direction);
    task.set(6, farthest);
    clocks += static_cast<double>(task.run(tasks_by_hand::support_at));
    CHECK(task.data(7) == sum(point, direction));
    CHECK(task.data(6) == std::max(farthest, sum(point, direction)));
  }
  check("supports", clocks / runs);
}

TEST_CASE("the recipe of rectangle tests has 0.8 to 1.2 times its assembly's clocks") {
  Random random;
  double clocks = 0;
  for (int i = 0; i < runs; ++i) {
    const Numbers halfspace{random.number() / 4096, random.number() / 4096, random.number()};
    const Numbers rectangle{random.positive() % 512, random.positive() % 512, random.positive() % 64,
                            random.positive() % 64};
    Task task;
    task.write(operands_at, halfspace);
    task.write_words(others_at, rectangle);
    clocks += static_cast<double>(task.run(tasks_by_hand::halfspace_at));
    Numbers corners;
    for (const std::int32_t x : {rectangle[0], rectangle[0] + rectangle[2]})
      for (const std::int32_t y : {rectangle[1], rectangle[1] + rectangle[3]})
        corners.push_back(halfspace[0] * x + halfspace[1] * y + halfspace[2]);
    CHECK(task.data(5) == *std::ranges::min_element(corners));
    CHECK(task.data(6) == *std::ranges::max_element(corners));
  }
  check("tests", clocks / runs);
}
