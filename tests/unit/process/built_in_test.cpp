#include "hw/kinds/load.h"
#include "hw/machines/area_table.h"
#include "hw/process/price.h"
#include "hw/process/process.h"
#include "tests/support/figure_ranges.h"
#include "tests/support/test.h"

// Tests of the built-in processes against their sources, and the clock, silicon and energy of Pixel-planes 4 in each by
// hand calculation.

using namespace csgsim;
using process::Process;

namespace {

/// Delays in ps, areas in nm2, energies in aJ, power in pW.
struct Expected {
  std::string name;
  std::uint64_t gate, fan_in, static_power, register_delay, register_energy, adder, access, read, read_bits, cell,
      transistor, wire_delay, wire_energy;
  double pixel_gates;  ///< gates on the clock's path through a pixel of Pixel-planes 4
};

// A pixel has 72 bits, so 7 bits of address: two levels of gates with four inputs or one with eight, and a driver; four
// gates select, two form the carry.
const std::vector<Expected> all{
    {"nmos-3um", 4000, 8, 50'000'000, 16'000, 8'000'000, 6'400'000, 52'000, 320'000'000, 65'536, 550'000'000,
     1'700'000'000, 200, 6'000'000, 1 + 1 + 4 + 2},
    {"cmos-45nm", 16, 4, 20'000, 48, 4000, 3125, 200, 156'250, 65'536, 57'700, 200'000, 100, 121'000, 2 + 1 + 4 + 2},
    {"cmos-7nm", 7, 4, 2000, 21, 1200, 940, 90, 117'200, 65'536, 4500, 12'100, 150, 80'000, 2 + 1 + 4 + 2},
};

constexpr double logic = 434;  ///< transistors of a pixel and its node
constexpr double pixels = 512 * 512;

/// Area in mm2 of a pixel with 72 bits of three transistors.
double pixel_area(const Expected& one) {
  return (logic * static_cast<double>(one.transistor) + 72 * 3 * static_cast<double>(one.cell)) * 1e-12;
}

double shared_transistors(const machines::Machine& machine) {
  return machines::controller_transistors + static_cast<double>(machine.link.width * machine.link.fifo_depth) *
                                                machines::fifo_transistors / machines::fifo_bits;
}

}  // namespace

TEST_CASE("the built-in processes have the figures of their sources") {
  REQUIRE(process::process_names().size() == all.size());
  for (const Expected& one : all) {
    CAPTURE(one.name);
    const Process read = process::load_process(one.name);
    CHECK(read.gate_delay == one.gate);
    CHECK(read.gate_fan_in == one.fan_in);
    CHECK(read.static_power == one.static_power);
    CHECK(read.register_delay == one.register_delay);
    CHECK(read.register_energy == one.register_energy);
    CHECK(read.adder_energy == one.adder);
    CHECK(read.memory_access == one.access);
    CHECK(read.memory_energy == one.read);
    CHECK(read.memory_bits == one.read_bits);
    CHECK(read.memory_transistor_area == one.cell);
    CHECK(read.transistor_area == one.transistor);
    CHECK(read.wire_delay == one.wire_delay);
    CHECK(read.wire_energy == one.wire_energy);
  }
}

TEST_CASE("every assumed figure of a built-in process has a range with a reason") {
  for (const Expected& row : all) {
    for (const machines::Figure& figure : process::load_process(row.name).figures) {
      CAPTURE(row.name);
      CAPTURE(figure.key);
      if (figure.provenance != "assumed") continue;
      REQUIRE(figure.range.has_value());
      CHECK(figure.range->reason.size() > 10);
      CHECK(figure.range->low <= std::stoll(figure.value));
      CHECK(figure.range->high >= std::stoll(figure.value));
    }
  }
}

TEST_CASE("published figures of the processes follow from their sources' statements") {
  const Process old = process::load_process("cmos-45nm");
  CHECK(old.gate_delay == std::llround(std::floor(360 * 0.045)));  // ps per um of gate length
  CHECK(old.adder_energy == 100'000 / 32);                         // 0.1 pJ, 32 bits
  CHECK(old.memory_energy == 10'000'000 / 64);                     // 10 pJ, 64 bits
  CHECK(old.memory_bits == 8 * 1024 * 8);                          // 8 KB
  CHECK(old.memory_transistor_area == 57'700);                     // 0.346 um2 / 6
  CHECK(old.wire_energy == 310'000'000 / 256 / 10 / 1000 * 1000);  // 310 pJ, 256 bits, 10 mm
  const Process today = process::load_process("cmos-7nm");
  CHECK(today.adder_energy == doctest::Approx(30'000 / 32.0).epsilon(0.005));      // 0.03 pJ
  CHECK(today.memory_energy == doctest::Approx(7'500'000 / 64.0).epsilon(0.001));  // 7.5 pJ
  CHECK(today.transistor_area == doctest::Approx(83.27e12 / 6.9e9).epsilon(0.005));
  CHECK(today.memory_transistor_area == 4500);  // 0.027 um2 / 6
}

TEST_CASE("each built-in process yields the hand-calculated clock and silicon and energy") {
  const machines::Machine machine = kinds::load("pixel-planes-4");
  for (const Expected& one : all) {
    CAPTURE(one.name);
    const Process read = process::load_process(one.name);
    const auto gate = static_cast<double>(one.gate);
    const double ps = static_cast<double>(one.register_delay + one.access) + one.pixel_gates * gate;
    const auto clock = process::clock_of(machine, read);
    REQUIRE(clock.has_value());
    CHECK(clock->path.name == "pixel");
    CHECK(clock->path.ps == doctest::Approx(ps));
    CHECK(clock->hz == static_cast<std::uint64_t>(std::llround(1e12 / ps)));
    const double area = pixel_area(one);
    const double shared = shared_transistors(machine);
    const machines::Resources resources{static_cast<std::uint64_t>(pixels), static_cast<std::uint64_t>(pixels) * 72};
    CHECK(*process::machine_mm2(machine, resources, read) ==
          doctest::Approx(pixels * area + shared * static_cast<double>(one.transistor) * 1e-12));
    // Two ports of a bit, from a memory of 72 bits instead of 65,536; two adders, seven flip-flops, two wires.
    const double attojoules = 2 * static_cast<double>(one.read) * std::sqrt(72 / 65'536.0) +
                              2 * static_cast<double>(one.adder) + 7 * static_cast<double>(one.register_energy) +
                              2 * std::sqrt(area) * static_cast<double>(one.wire_energy);
    CHECK(*process::frame_joules(machine, resources, {1'000'000'000, 0}, read) / (attojoules * 1e-9) ==
          doctest::Approx(1));
    const double watts = (pixels * logic + shared) / 4 * static_cast<double>(one.static_power) * 1e-12;
    CHECK(*process::frame_joules(machine, resources, {0, 3}, read) / (3 * watts) == doctest::Approx(1));
  }
  // The paths take 392 and 174 ps.
  CHECK(process::clock_of(machine, process::load_process("cmos-45nm"))->hz == 2'551'020'408);
  CHECK(process::clock_of(machine, process::load_process("cmos-7nm"))->hz == 5'747'126'437);
}

TEST_CASE("each parameter of a process is accepted up to its limits") {
  constexpr std::int64_t million = 1'000'000;
  constexpr auto ranges = std::to_array<testing::FigureRange>({
      {"gate.delay", 1, million},
      {"gate.fan_in", 2, 64},
      {"gate.static_power", 0, 1000 * million},
      {"register.delay", 1, million},
      {"register.energy", 0, million * million},
      {"adder.energy", 0, million * million},
      {"memory.access", 1, 10 * million},
      {"memory.read_energy", 0, 1000 * million * million},
      {"memory.read_bits", 1, 1000 * million},
      {"memory.transistor_area", 1, million * million},
      {"transistor.area", 1, million * million},
      {"wire.delay", 0, million},
      {"wire.energy", 0, million * million},
  });
  testing::check_figure_ranges("cmos-45nm", ranges,
                               [](const std::string& text) { return process::load_process(text); });
}

TEST_CASE("the clocks of extreme processes stay within the range of a machine description") {
  const machines::Machine machine = kinds::load("pixel-planes-4");
  const std::string fast = "+gate.delay=1+register.delay=1+memory.access=1+wire.delay=0";
  CHECK(process::clock_of(machine, process::load_process("cmos-7nm" + fast))->hz == 10'000'000'000);  // 11 ps
  const std::string slow = "+memory.access=10000000+register.delay=1000000+gate.delay=1000000";
  CHECK(process::clock_of(machine, process::load_process("cmos-7nm" + slow))->hz == 50'000);  // 20 us
}

TEST_CASE("a clock rate below one hertz becomes one hertz") {
  // The largest transistors and the slowest wires: 434 and 4096 times three of a mm2 give a pitch of 113 mm; 8192 of
  // these take 0.93 s. With two reads a bit has five transistors: 143 mm and 1.17 s.
  const std::string slowest =
      "cmos-7nm+transistor.area=1000000000000+memory.transistor_area=1000000000000+wire.delay=1000000";
  const std::string largest = "pixel-planes-4+array.width=16384+array.height=16384+array.memory_bits=4096";
  const auto one = process::clock_of(kinds::load(largest + "+memory.reads=2"), process::load_process(slowest));
  REQUIRE(one.has_value());
  CHECK(one->path.ps > 1e12);
  CHECK(one->hz == 1);
}
