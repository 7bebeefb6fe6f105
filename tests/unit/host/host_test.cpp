#include "hw/host/host.h"

#include "hw/host/recipes.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "hw/processors/processor.h"
#include "sim/observe/bound.h"
#include "tests/support/test.h"
#include "tests/support/two_cubes.h"

using namespace csgsim;

namespace {

machines::Machine machine_named(const std::string& name) {
  machines::Machine machine = kinds::load(name);
  machines::set_picture_size(machine, {64, 64});
  return machine;
}

isa::Program drawn_on(const machines::Machine& machine) { return testing::two_cubes(machine, {2, 2, 2}); }

double clocks_on_mc68000(const processors::Operations& operations) {
  return processors::clocks(operations, processors::load_processor("mc68000"));
}

}  // namespace

TEST_CASE("a machine's host can be any processor shipped with csgsim") {
  const std::vector<std::string_view> known = processors::processor_names();
  std::vector<std::string_view> names(machines::host_processor_names.begin() + 1, machines::host_processor_names.end());
  CHECK(machines::host_processor_names.front() == machines::ideal_value);
  CHECK(std::is_permutation(names.begin(), names.end(), known.begin(), known.end()));
  for (const std::string_view name : names) {
    const machines::Machine machine = machine_named(fmt::format("pixel-planes-4+host.processor={}", name));
    const isa::Program program = drawn_on(machine);
    const double seconds =
        processors::seconds(host::count_operations(program, machine), processors::load_processor(std::string(name)));
    const auto clocks = static_cast<double>(host::compile_clocks(program, machine));
    CHECK(clocks >= seconds * 10e6);
    CHECK(clocks < seconds * 10e6 + 1);
  }
}

TEST_CASE("an ideal host compiles in no time") {
  const machines::Machine machine = machine_named("pixel-planes-4+host.processor=ideal");
  const isa::Program program = drawn_on(machine);
  CHECK(host::compile_clocks(program, machine) == 0);
  CHECK(host::time_frame(program, machine) == machines::time_frame(program, machine));
}

TEST_CASE("the host's clocks are those of the written instructions and all preparation") {
  const machines::Machine machine = machine_named("scan-line");
  const isa::Program program = drawn_on(machine);
  isa::Preparation sum = *program.preparation;
  host::Writer writer(machine.link.width);
  for (const isa::Segment& segment : program.segments) {
    sum += *segment.preparation;
    writer.begin(segment.region);
    for (const isa::Instruction& one : segment.instructions) writer.add(one);
  }
  const double instructions = clocks_on_mc68000(host::count_operations(writer.written()));
  double prepared = 0;
  for (const host::Recipe& recipe : host::recipes())
    prepared += static_cast<double>(sum.*recipe.count) * clocks_on_mc68000(recipe.each);
  CHECK(prepared > 0);
  CHECK(instructions > 0);
  // The processor runs at 8 MHz, the machine at 10 MHz.
  const double clocks = (prepared + instructions) * 10 / 8;
  CHECK(static_cast<double>(host::compile_clocks(program, machine)) == doctest::Approx(clocks).epsilon(1e-6));
}

TEST_CASE("the host only builds the display model if the machine divides the picture") {
  for (const char* name : {"pixel-square", "multi-processor"}) {
    const machines::Machine machine = machine_named(name);
    const isa::Program program = drawn_on(machine);
    REQUIRE(!program.display_model.empty());
    for (const isa::Segment& segment : program.segments) CHECK(*segment.preparation == isa::Preparation{});
    const std::uint64_t longs = (program.display_model.size() + 3) / 4;
    double clocks = static_cast<double>(longs) * clocks_on_mc68000(host::model_long_operations());
    for (const host::Recipe& recipe : host::recipes())
      clocks += static_cast<double>((*program.preparation).*recipe.count) * clocks_on_mc68000(recipe.each);
    clocks *= static_cast<double>(machine.clock_hz) / 8e6;
    CHECK(static_cast<double>(host::compile_clocks(program, machine)) == doctest::Approx(clocks).epsilon(1e-5));
  }
}

TEST_CASE("a host slower than the machine limits the frame and a faster one does not") {
  const machines::Machine slow = machine_named("pixel-planes-4+host.processor=mc68000");
  const isa::Program program = drawn_on(slow);
  const auto bound_on = [&](const machines::Machine& machine) {
    const machines::FrameTiming timing = host::time_frame(program, machine);
    engine::RunResult result;
    engine::put(timing, result);
    return *observe::find_bottleneck(result, machine);
  };
  const observe::Bottleneck bound = bound_on(slow);
  CHECK(bound.by_host);
  CHECK(bound.sentence.find("The host needs ") != std::string::npos);
  const observe::Bottleneck kept_up = bound_on(machine_named("pixel-planes-4+host.processor=ideal"));
  CHECK(!kept_up.by_host);
  CHECK(kept_up.part == bound.part);
  CHECK(bound.sentence.starts_with(kept_up.sentence));
}

TEST_CASE("work on the model adds to host_model_clocks and not to host_clocks") {
  const machines::Machine machine = machine_named("pixel-planes-4+host.processor=mc68000");
  isa::Program program = drawn_on(machine);
  *program.model_preparation = {};
  const machines::FrameTiming without = host::time_frame(program, machine);
  CHECK(without.host_model_clocks == 0);
  program.model_preparation->supports = 1000;
  const machines::FrameTiming timing = host::time_frame(program, machine);
  CHECK(timing.host_clocks == without.host_clocks);
  for (const host::Recipe& recipe : host::recipes())
    if (recipe.name == "supports")
      CHECK(static_cast<double>(timing.host_model_clocks) ==
            doctest::Approx(1000 * clocks_on_mc68000(recipe.each) * 10 / 8).epsilon(1e-6));
  CHECK(host::time_frame(program, machine_named("pixel-planes-4+host.processor=ideal")).host_model_clocks == 0);
}

TEST_CASE("a Program with an excessive amount of host preparation is rejected") {
  const machines::Machine machine = machine_named("pixel-planes-4+host.processor=mc68000");
  isa::Program program = drawn_on(machine);
  program.preparation->planes = 10'000'000'000'000;
  CHECK_THROWS_WITH_AS(host::compile_clocks(program, machine), doctest::Contains("more than the limit of 9e15"),
                       InputError);
}

TEST_CASE("a host's operations are the sum over its preparation and instructions") {
  const machines::Machine machine = machine_named("pixel-planes-4+host.processor=mc68000");
  isa::Program program;
  program.shape = machine.array;
  *program.preparation = {.planes = 2, .points = 3};
  program.segments.push_back({.region = {0, 0, 64, 64}, .instructions = {{.opcode = isa::Opcode::enable_all}}});
  program.segments.push_back({.region = {0, 0, 64, 64}, .instructions = {{.opcode = isa::Opcode::enable_all}}});
  program.segments[0].preparation->boxes = 5;
  program.segments[1].preparation->boxes = 7;
  host::Writer writer(machine.link.width);
  for (const isa::Segment& segment : program.segments) {
    writer.begin(segment.region);
    writer.add(segment.instructions[0]);
  }
  processors::Operations sum = host::count_operations(writer.written());
  for (const host::Recipe& recipe : host::recipes()) {
    if (recipe.name == "planes") sum += 2 * recipe.each;
    if (recipe.name == "points") sum += 3 * recipe.each;
    if (recipe.name == "boxes") sum += 12 * recipe.each;
  }
  CHECK(host::count_operations(program, machine) == sum);
  // The host of a machine that divides the model builds the model in longs of four bytes and writes no instructions.
  const machines::Machine dividing = machine_named("pixel-square");
  for (const std::size_t bytes : {0U, 1U, 4U, 5U, 8U}) {
    program.display_model.resize(bytes);
    processors::Operations made = (bytes + 3) / 4 * host::model_long_operations();
    for (const host::Recipe& recipe : host::recipes()) {
      if (recipe.name == "planes") made += 2 * recipe.each;
      if (recipe.name == "points") made += 3 * recipe.each;
    }
    CHECK(host::count_operations(program, dividing) == made);
  }
}

TEST_CASE("host work up to the limit of exact clocks is accepted and more rejected") {
  const machines::Machine machine = machine_named("pixel-planes-4+host.processor=mc68000");
  isa::Program program;
  program.shape = machine.array;
  program.preparation->planes = 1'000'000;
  const auto of_million = static_cast<double>(host::compile_clocks(program, machine));
  // The limit is 9e15 clocks.
  const double most = 9e15 / of_million * 1e6;
  program.preparation->planes = static_cast<std::uint64_t>(most * 0.9999);
  CHECK(static_cast<double>(host::compile_clocks(program, machine)) == doctest::Approx(9e15).epsilon(0.001));
  program.preparation->planes = static_cast<std::uint64_t>(most * 1.0001);
  CHECK_THROWS_WITH_AS(host::compile_clocks(program, machine), doctest::Contains("choose a faster host.processor"),
                       InputError);
}

TEST_CASE("exactly 9e15 host clocks are accepted and the next possible value rejected") {
  // The machine has the clock frequency of an MC68000, so both clocks are equal.
  machines::Machine machine = machine_named("pixel-planes-4+host.processor=mc68000");
  machine.clock_hz = processors::load_processor("mc68000").clock_hz;
  REQUIRE(machine.clock_hz == 8'000'000);
  isa::Program program;
  program.shape = machine.array;
  const auto clocks_of = [](std::string_view name) {
    for (const host::Recipe& recipe : host::recipes())
      if (recipe.name == name) return static_cast<std::uint64_t>(clocks_on_mc68000(recipe.each));
    return std::uint64_t{0};
  };
  const std::uint64_t plane = clocks_of("planes");
  const std::uint64_t value = clocks_of("values");
  constexpr std::uint64_t most = 9'000'000'000'000'000;
  const auto work_of = [&](std::uint64_t clocks) {
    std::uint64_t& values = program.preparation->values;
    for (values = 0; (clocks - values * value) % plane != 0; ++values) REQUIRE(values < plane);
    program.preparation->planes = (clocks - values * value) / plane;
  };
  work_of(most);
  CHECK(host::compile_clocks(program, machine) == most);
  // The clocks of a plane and of a value are multiples of 8; compiled code takes twice the manual's clocks.
  REQUIRE(std::gcd(plane, value) == 8);
  work_of(most + 8);
  CHECK_THROWS_AS(host::compile_clocks(program, machine), InputError);
}