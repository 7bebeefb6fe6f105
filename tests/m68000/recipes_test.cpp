// The prices of the host's most expensive recipes, compared with assembly on an MC68000.

#include "hw/host/recipes.h"

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
/// maximum, and do not count signs.
constexpr double most_off = 0.2;

constexpr std::uint32_t program_at = 0x1000;
constexpr std::uint32_t stack_at = 0x4000;
constexpr std::uint32_t operands_at = 0x5000;  ///< a0
constexpr std::uint32_t others_at = 0x5100;    ///< a1
constexpr std::uint32_t results_at = 0x5200;   ///< a2
constexpr std::uint32_t box_at = 0x5300;       ///< a3
constexpr std::uint64_t rts_clocks = 16;       ///< not part of a recipe
constexpr unsigned long_bits = 32;
constexpr std::int32_t bits_of_places = 12;

using Numbers = std::vector<std::int32_t>;

/// Operands with up to 28 bits, as those of the host, so that sums of products do not overflow.
class Random {
 public:
  std::int32_t number() { return static_cast<std::int32_t>(next()) >> 3; }
  std::int32_t positive() { return number() & 0x0fff'ffff; }
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
    processor_.a = {operands_at, others_at, results_at, box_at, 0, 0, 0, stack_at};
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

std::int32_t quotient(std::int32_t dividend, std::int32_t divisor) {
  return static_cast<std::int32_t>(std::int64_t{dividend} * (1 << bits_of_places) / divisor);
}

/// Whether the quotient fits a long without its sign.
bool is_divisible(std::int32_t dividend, std::int32_t divisor) {
  return (std::int64_t{std::abs(dividend)} >> (long_bits - bits_of_places)) < std::abs(std::int64_t{divisor});
}

constexpr int runs = 200;

/// Compares the mean clocks of a task with its recipe at the prices of the processor file.
void check(const char* name, double mean) {
  const auto clocks = static_cast<double>(
      processors::hand_written_clocks(host::recipe(name), processors::built_in_processor("mc68000")));
  const double ratio = clocks / mean;
  MESSAGE(fmt::format("{}: {} clocks by the recipe, {:.0f} by assembly, {:.3f}", name, clocks, mean, ratio));
  CHECK(ratio > 1 - most_off);
  CHECK(ratio < 1 + most_off);
}

}  // namespace

TEST_CASE("the tasks in assembly are the five with the most expensive recipes") {
  std::vector<std::pair<std::uint64_t, std::string_view>> prices;
  for (const host::Recipe& one : host::recipes())
    prices.emplace_back(processors::hand_written_clocks(one.each, processors::built_in_processor("mc68000")), one.name);
  std::ranges::sort(prices, std::greater());
  prices.resize(5);
  std::vector<std::string_view> names;
  for (const auto& [price, name] : prices) names.push_back(name);
  CHECK(names == std::vector<std::string_view>{"planes", "points", "colours", "supports", "tests"});
}

TEST_CASE("the recipe of planes is within a fifth of its assembly") {
  Random random;
  double clocks = 0;
  for (int done = 0; done < runs;) {
    const Numbers plane = random.numbers(4);
    const Numbers matrix = random.numbers(16);
    Numbers rows;
    for (std::size_t i = 0; i < 4; ++i) rows.push_back(sum(plane, std::span(matrix).subspan(4 * i, 4)));
    if (!std::ranges::all_of(rows, [&](std::int32_t row) { return is_divisible(row, rows[3]); })) continue;
    Task task;
    task.write(operands_at, plane);
    task.write(others_at, matrix);
    clocks += static_cast<double>(task.run(tasks_by_hand::plane_at));
    const Numbers expected{quotient(rows[2], rows[3]), quotient(rows[1], rows[3]), quotient(rows[0], rows[3])};
    CHECK(task.longs(results_at, 3) == expected);
    ++done;
  }
  check("planes", clocks / runs);
}

TEST_CASE("the recipe of points is within a fifth of its assembly") {
  Random random;
  double clocks = 0;
  for (int done = 0; done < runs;) {
    const Numbers point = random.numbers(3);
    const Numbers matrix = random.numbers(12);
    Numbers rows;
    for (std::size_t i = 0; i < 3; ++i)
      rows.push_back(sum(point, std::span(matrix).subspan(4 * i, 3)) + matrix[4 * i + 3] / 16);
    if (rows[2] <= 0 || !is_divisible(rows[0], rows[2]) || !is_divisible(rows[1], rows[2])) continue;
    Numbers stored = matrix;
    for (std::size_t i = 0; i < 3; ++i) stored[4 * i + 3] /= 16;
    Task task;
    task.write(operands_at, point);
    task.write(others_at, stored);
    const Numbers box{-1000, 1000, -1000, 1000, -1000, 1000};
    task.write(box_at, box);
    clocks += static_cast<double>(task.run(tasks_by_hand::point_at));
    const Numbers results{quotient(rows[1], rows[2]), quotient(rows[0], rows[2])};
    CHECK(task.longs(results_at, 2) == results);
    const Numbers values{rows[2], results[0], results[1]};
    Numbers enlarged;
    for (std::size_t i = 0; i < 3; ++i) {
      enlarged.push_back(std::min(box[2 * i], values[i]));
      enlarged.push_back(std::max(box[2 * i + 1], values[i]));
    }
    CHECK(task.longs(box_at, 6) == enlarged);
    ++done;
  }
  check("points", clocks / runs);
}

TEST_CASE("the recipe of colours is within a fifth of its assembly") {
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

TEST_CASE("the recipe of supports is within a fifth of its assembly") {
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

TEST_CASE("the recipe of tests is within a fifth of its assembly") {
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
