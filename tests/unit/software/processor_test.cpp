#include "hw/processors/processor.h"

#include "hw/machines/change_error.h"
#include "hw/processors/built_in.h"
#include "places.h"
#include "sim/software/cost/operations.h"
#include "tests/support/place_in.h"
#include "tests/support/test.h"

using namespace csgsim;
using processors::load_processor;
using processors::Processor;
using processors::read_processor;
using software::Operation;
using software::Operations;

namespace {

std::string text_of(std::string_view name) {
  for (const machines::BuiltIn& one : processors::built_in_processors())
    if (one.name == name) return std::string(one.text);
  FAIL("no built-in processor has this name");
  return {};
}

/// Returns the MC68000's description with one piece of its text replaced.
std::string changed(std::string_view from, std::string_view to) {
  std::string text = text_of("mc68000");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  return text;
}

std::string message(std::string_view text) {
  return testing::error_of([&] { read_processor(text, "my.toml"); });
}

const machines::Figure& figure_of(const Processor& processor, std::string_view key) {
  const auto found = std::ranges::find(processor.figures, key, &machines::Figure::key);
  REQUIRE(found != processor.figures.end());
  return *found;
}

std::uint32_t price_of(const Processor& processor, Operation kind) {
  return processor.prices[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST_CASE("every built-in processor has a price with a source for every operation") {
  REQUIRE(processors::processor_names().size() >= 2);
  for (const std::string_view name : processors::processor_names()) {
    CAPTURE(name);
    const Processor processor = load_processor(std::string(name));
    CHECK(processor.name == name);
    CHECK(processor.figures.size() == software::operation_kinds + 2 + processors::compiled_kinds);
    for (std::size_t kind = 0; kind < software::operation_kinds; ++kind) {
      const machines::Figure& figure =
          figure_of(processor, fmt::format("price.{}", software::operation_rows[kind].name));
      CHECK(figure.value == fmt::format("{}", processor.prices[kind]));
      CHECK(figure.unit == "clocks");
      // Operations of several instructions, waits of an i860 and microprograms of a VAX have no manual page.
      const bool is_made = kind == static_cast<std::size_t>(Operation::multiply_long) ||
                           kind == static_cast<std::size_t>(Operation::divide_long);
      if (name != "i860" && name != "vax-780" && !is_made) CHECK(figure.provenance == "published");
      CHECK(processors::meaning_of_figure(figure.key) == software::operation_rows[kind].meaning);
      // Some processors shift in the same clocks for any number of places.
      if (kind != static_cast<std::size_t>(Operation::shifted_bit)) CHECK(processor.prices[kind] > 0);
    }
    for (const char* const program : {"factor", "standard", "early_out", "positional", "status", "bit_parallel"})
      CHECK(figure_of(processor, fmt::format("compiler.{}", program)).provenance == "assumed");
  }
}

TEST_CASE("every assumed number of a built-in processor has a range with a reason") {
  for (const machines::BuiltIn& one : processors::built_in_processors()) {
    for (const machines::Figure& figure : load_processor(std::string(one.name)).figures) {
      CAPTURE(one.name);
      CAPTURE(figure.key);
      if (figure.provenance != "assumed") continue;
      REQUIRE(figure.range.has_value());
      CHECK(figure.range->reason.size() > 10);
      CHECK(figure.range->low <= std::stoll(figure.value));
      CHECK(figure.range->high >= std::stoll(figure.value));
    }
  }
}

TEST_CASE("the MC68000 has the clocks of its manual") {
  const Processor processor = load_processor("mc68000");
  CHECK(processor.clock_hz == 8'000'000);
  CHECK(processor.compiler_factors == std::array<std::uint32_t, 6>{2000, 2090, 2210, 2960, 2520, 4870});
  CHECK(price_of(processor, Operation::load) == 12);
  CHECK(price_of(processor, Operation::load_long) == 16);
  CHECK(price_of(processor, Operation::store) == 12);
  CHECK(price_of(processor, Operation::store_long) == 16);
  CHECK(price_of(processor, Operation::move) == 4);
  CHECK(price_of(processor, Operation::add) == 4);
  CHECK(price_of(processor, Operation::add_long) == 8);
  CHECK(price_of(processor, Operation::compare) == 4);
  CHECK(price_of(processor, Operation::compare_long) == 6);
  CHECK(price_of(processor, Operation::logic) == 4);
  CHECK(price_of(processor, Operation::logic_long) == 8);
  CHECK(price_of(processor, Operation::shift) == 6);
  CHECK(price_of(processor, Operation::shift_long) == 8);
  CHECK(price_of(processor, Operation::shifted_bit) == 2);
  CHECK(price_of(processor, Operation::multiply) == 70);
  CHECK(price_of(processor, Operation::divide) == 140);
  CHECK(price_of(processor, Operation::divide_long) == 1576);
  CHECK(price_of(processor, Operation::branch) == 8);
  CHECK(price_of(processor, Operation::branch_taken) == 10);
  CHECK(price_of(processor, Operation::call) == 18);
  CHECK(price_of(processor, Operation::come_back) == 16);
}

TEST_CASE("operations take their clocks times the compiler's factor at the clock rate") {
  software::Counting count;
  count(Operation::load, 3);
  count(Operation::branch);
  count.shift(5);
  const Processor by_hand = load_processor("mc68000+compiler.factor=1000");
  CHECK(processors::clocks(count.done(), by_hand) == 3 * 12 + 8 + 8 + 5 * 2);
  CHECK(processors::seconds(count.done(), by_hand) == 62 / 8e6);
  const Processor compiled = load_processor("mc68000+compiler.factor=2500+clock.frequency=10000000");
  CHECK(compiled.name == "mc68000+compiler.factor=2500+clock.frequency=10000000");
  CHECK(processors::clocks(count.done(), compiled) == 155);
  CHECK(processors::seconds(count.done(), compiled) == 155 / 10e6);
  CHECK(processors::clocks(Operations{}, by_hand) == 0);
  CHECK(processors::clocks(count.done(), by_hand, processors::Compiled::bit_parallel) == doctest::Approx(62 * 4.87));
  CHECK(processors::seconds(count.done(), by_hand, processors::Compiled::status) == doctest::Approx(62 * 2.52 / 8e6));
}

TEST_CASE("an error in a processor file is reported with its place and a fix") {
  std::string text = changed("[price.branch]", "[price.branches]");
  CHECK(message(text) ==
        testing::place_in(text, "branches]") + ": unknown key 'price.branches'; the nearest known is 'price.branch'");
  CHECK(message("name = \"one\"\ndescription = \"none\"\n") ==
        "my.toml:1:1: key 'clock.frequency' is missing; add a table [clock.frequency] with value, unit, provenance and "
        "source");
  text = changed("value = 8_000_000", "value = 0");
  CHECK(message(text) == testing::place_in(text, "0\n") + ": clock.frequency is 0; it must be 1 to 10000000000 Hz");
  text = changed("provenance = \"published\"", "provenance = \"fitted\"");
  CHECK(message(text).find("price.load has the provenance 'fitted'; write 'published' or 'assumed'") !=
        std::string::npos);
  text = changed("unit = \"clocks\"", "unit = \"seconds\"");
  CHECK(message(text) ==
        testing::place_in(text, "\"seconds\"") + ": price.load has the unit 'seconds'; write 'clocks'");
  text = changed("value = 12\n", "value = 12.5\n");
  CHECK(message(text) ==
        testing::place_in(text, "12.5\n") + ": price.load is a number with a point; make it an integer");
  text = changed("name = \"mc68000\"", "kind = \"frame-buffer\"\nname = \"mc68000\"");
  CHECK(message(text).find("unknown key 'kind'") != std::string::npos);
  text = changed("[price.call]", "price.call = 18\n[price.cal]");
  CHECK_FALSE(message(text).empty());
}

TEST_CASE("parameters of a processor file accept exactly their documented ranges") {
  struct Range {
    std::string key;
    std::uint64_t least;
    std::uint64_t most;
    std::uint64_t (*kept)(const Processor& processor);
  };
  const std::vector<Range> ranges{
      {"clock.frequency", 1, 10'000'000'000, [](const Processor& one) { return one.clock_hz; }},
      {"compiler.factor", 100, 100'000,
       [](const Processor& one) { return std::uint64_t{one.compiler_factors.front()}; }},
      {"compiler.bit_parallel", 100, 100'000,
       [](const Processor& one) { return std::uint64_t{one.compiler_factors.back()}; }},
      {"memory.price", 1, 10'000'000, [](const Processor& one) { return std::uint64_t{one.memory_price}; }},
      {"price.load", 0, 1'000'000, [](const Processor& one) { return std::uint64_t{one.prices.front()}; }},
      {"price.come_back", 0, 1'000'000, [](const Processor& one) { return std::uint64_t{one.prices.back()}; }}};
  for (const Range& range : ranges) {
    CAPTURE(range.key);
    const auto loaded = [&](std::uint64_t value) {
      return load_processor(fmt::format("mc68000+{}={}", range.key, value));
    };
    CHECK(range.kept(loaded(range.least)) == range.least);
    CHECK(range.kept(loaded(range.most)) == range.most);
    CHECK_THROWS_AS(loaded(range.least - 1), machines::ChangeError);
    CHECK_THROWS_AS(loaded(range.most + 1), machines::ChangeError);
  }
}

TEST_CASE("an Uncounted counter reports no operations and only Counting counts") {
  const software::Uncounted uncounted;
  uncounted(Operation::load);
  uncounted.shift(3);
  CHECK(uncounted.done() == Operations{});
  CHECK(software::Counting::counts);
  CHECK(!software::Uncounted::counts);
}

TEST_CASE("a processor file without the price of an operation is rejected") {
  for (const processors::OperationRow& row : software::operation_rows) {
    std::string text = text_of("mc68000");
    const std::size_t begin = text.find(fmt::format("[price.{}]", row.name));
    REQUIRE(begin != std::string::npos);
    text.erase(begin, text.find("\n\n", begin) - begin);
    CHECK(message(text).find(fmt::format("key 'price.{}' is missing", row.name)) != std::string::npos);
  }
}

TEST_CASE("a processor is found by name or file and its name lists edited parameters") {
  CHECK_THROWS_WITH(load_processor("mc6800"),
                    "there is no processor 'mc6800'; did you mean mc68000? The processors are mc68000, mc68020-weitek, "
                    "vax-780, i486dx2, i860; the name of a processor file must end in .toml");
  CHECK_THROWS_AS(load_processor("mc68000+price.load=-1"), machines::ChangeError);
  CHECK_THROWS_AS(load_processor("mc68000+price.lode=1"), machines::ChangeError);
  CHECK_THROWS_AS(load_processor("no such file.toml"), InputError);
  CHECK_THROWS_AS(processors::meaning_of_figure("price.lode"), std::out_of_range);

  const std::string file = std::string(CSGSIM_SOURCE_DIR) + "/hw/processors/mc68000.toml";
  CHECK(load_processor(file).name == "mc68000");
  CHECK(load_processor(file + "+price.load=13").name == "mc68000+price.load=13");
  const std::string edited = "edited_processor.toml";
  std::ofstream(edited) << changed("value = 8_000_000", "value = 10_000_000");
  const Processor processor = load_processor(edited);
  CHECK(processor.name == "mc68000+clock.frequency=10000000");
  CHECK(figure_of(processor, "clock.frequency").provenance == "assumed");
}
