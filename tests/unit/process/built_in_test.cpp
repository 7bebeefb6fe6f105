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

/// Delays in ps, areas in nm2, energies in aJ, power in pW, voltages in mV, capacitances in fF, times of refresh in ns.
struct Expected {
  std::string name;
  std::uint64_t gate, fan_in, static_power, family, utilization, supply, register_delay, register_energy, adder,
      clock_lines, access, read, read_bits, cell_transistors, cell, periphery, refresh, transistor, wire_delay,
      wire_capacitance;
  double pixel_gates;  ///< gates on the clock's path through a pixel of Pixel-planes 4
};

// A pixel has 72 bits, so 7 bits of address: two levels of gates with four inputs or one with eight, and a driver; four
// gates select, two form the carry.
const std::vector<Expected> all{
    {"nmos-3um",  4000,   8, 88'000'000,    1,   100,       5000,        16'000, 8'000'000, 6'400'000,    2, 52'000,
     320'000'000, 65'536, 3, 1'633'500'000, 116, 2'000'000, 475'000'000, 200,    250,       1 + 1 + 4 + 2},
    {"cmos-1.6um", 576,         4,      1000, 0,           100, 5000, 1728,        4'400'000, 3'400'000, 2,
     18'088,       170'000'000, 65'536, 6,    748'800'000, 40,  0,    430'000'000, 200,       250,       2 + 1 + 4 + 2},
    {"cmos-45nm", 16,      4,      20'000, 0,       70, 900, 48,      4000, 3125, 1,
     200,         156'250, 65'536, 6,      346'000, 60, 0,   200'000, 100,  299,  2 + 1 + 4 + 2},
    {"cmos-7nm", 7,       4,      2000, 0,      100, 750, 21,     1200, 940, 1,
     90,         117'200, 65'536, 6,    27'000, 60,  0,   12'100, 150,  278, 2 + 1 + 4 + 2},
};

constexpr double pixels = 512 * 512;

/// Transistors of a pixel and its node: 344 + 90 in static CMOS, 217 + 50 in nMOS.
double logic_of(const Expected& one) { return one.family == 0 ? 434 : 267; }

double transistor_mm2(const Expected& one) {
  return static_cast<double>(one.transistor) * 100 / static_cast<double>(one.utilization) * 1e-12;
}

/// Area in mm2 of a pixel with 72 bits.
double pixel_area(const Expected& one) {
  return logic_of(one) * transistor_mm2(one) +
         72 * static_cast<double>(one.cell) * (1 + static_cast<double>(one.periphery) / 100) * 1e-12;
}

double shared_transistors(const machines::Machine& machine, const Expected& one) {
  const auto count = [&](const machines::Transistors& of) {
    return static_cast<double>(one.family == 0 ? of.cmos : of.nmos);
  };
  return count(machines::controller_transistors) + static_cast<double>(machine.link.width * machine.link.fifo_depth) *
                                                       count(machines::fifo_transistors) / machines::fifo_bits;
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
    CHECK(read.family == one.family);
    CHECK(read.utilization == one.utilization);
    CHECK(read.supply == one.supply);
    CHECK(read.clock_lines == one.clock_lines);
    CHECK(read.cell_transistors == one.cell_transistors);
    CHECK(read.cell_area == one.cell);
    CHECK(read.periphery == one.periphery);
    CHECK(read.refresh_time == one.refresh);
    CHECK(read.transistor_area == one.transistor);
    CHECK(read.wire_delay == one.wire_delay);
    CHECK(read.wire_capacitance == one.wire_capacitance);
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
  CHECK(old.cell_area == 346'000);                                 // 0.346 um2
  // 310 pJ, 256 bits, 10 mm.
  CHECK(process::wire_joules(old) * 1e12 == doctest::Approx(310.0 / 256 / 10).epsilon(0.005));
  const Process today = process::load_process("cmos-7nm");
  CHECK(today.adder_energy == doctest::Approx(30'000 / 32.0).epsilon(0.005));      // 0.03 pJ
  CHECK(today.memory_energy == doctest::Approx(7'500'000 / 64.0).epsilon(0.001));  // 7.5 pJ
  CHECK(today.transistor_area == doctest::Approx(83.27e12 / 6.9e9).epsilon(0.005));
  CHECK(today.cell_area == 27'000);                                                               // 0.027 um2
  CHECK(process::wire_joules(today) * 1e12 == doctest::Approx(200.0 / 256 / 10).epsilon(0.005));  // 200 pJ
}

TEST_CASE("each built-in process yields the hand-calculated clock and silicon and energy") {
  const machines::Machine machine = kinds::load("pixel-planes-4");
  for (const Expected& one : all) {
    CAPTURE(one.name);
    const Process read = process::load_process(one.name);
    const auto gate = static_cast<double>(one.gate);
    const double area = pixel_area(one);
    const double pixel = static_cast<double>(one.register_delay + one.access) + one.pixel_gates * gate;
    const double wire_path = static_cast<double>(one.register_delay) +
                             256 * std::sqrt(area) * static_cast<double>(one.wire_delay);  // half a side
    const double ps = std::max(pixel, wire_path);
    const auto clock = process::clock_of(machine, read);
    REQUIRE(clock.has_value());
    // Large static cells make the array of 1.6 um wide.
    CHECK(clock->path.name == (one.name == "cmos-1.6um" ? "wire" : "pixel"));
    CHECK(clock->path.ps == doctest::Approx(ps));
    CHECK(clock->hz == static_cast<std::uint64_t>(std::llround(1e12 / ps)));
    const double shared = shared_transistors(machine, one);
    const machines::Resources resources{static_cast<std::uint64_t>(pixels), static_cast<std::uint64_t>(pixels) * 72};
    CHECK(*process::machine_mm2(machine, resources, read) ==
          doctest::Approx(pixels * area + shared * transistor_mm2(one)));
    const double volts = static_cast<double>(one.supply) / 1000;
    const double wire = static_cast<double>(one.wire_capacitance) * 1000 * volts * volts / 2;  // aJ a mm
    // Two ports of a bit, from a memory of 72 bits instead of 65,536; two adders, seven flip-flops, two wires.
    const double attojoules = 2 * static_cast<double>(one.read) * std::sqrt(72 / 65'536.0) +
                              2 * static_cast<double>(one.adder) + 7 * static_cast<double>(one.register_energy) +
                              2 * std::sqrt(area) * wire;
    CHECK(*process::frame_joules(machine, resources, {1'000'000'000, 0}, read) / (attojoules * 1e-9) ==
          doctest::Approx(1));
    const double gates = (pixels * logic_of(one) + shared) / (one.family == 0 ? 4 : 3);
    const double clock_wires =
        pixels * static_cast<double>(one.clock_lines) * std::sqrt(area) * 2 * wire * 1e-18 * 10e6;
    const double refresh = one.refresh == 0 ? 0
                                            : pixels * 72 * 2 * static_cast<double>(one.read) * 1e-18 *
                                                  std::sqrt(72 / 65'536.0) / (static_cast<double>(one.refresh) * 1e-9);
    const double watts = gates * static_cast<double>(one.static_power) * 1e-12 + clock_wires + refresh;
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
      {"logic.utilization", 1, 100},
      {"supply.voltage", 1, 100'000},
      {"clock.lines", 0, 16},
      {"memory.cell_transistors", 1, 16},
      {"memory.cell_area", 1, 10 * million * million},
      {"memory.periphery", 0, 10'000},
      {"memory.refresh_time", 0, million * million},
      {"transistor.area", 1, million * million},
      {"wire.delay", 0, million},
      {"wire.capacitance", 0, 100'000},
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
  // The largest cells and the slowest wires: 4096 of ten mm2, a third more with two reads and 60 % of periphery give a
  // pitch of 296 mm; 8192 of these take 2.4 s.
  const std::string slowest =
      "cmos-7nm+transistor.area=1000000000000+memory.cell_area=10000000000000+wire.delay=1000000";
  const std::string largest = "pixel-planes-4+array.width=16384+array.height=16384+array.memory_bits=4096";
  const auto one = process::clock_of(kinds::load(largest + "+memory.reads=2"), process::load_process(slowest));
  REQUIRE(one.has_value());
  CHECK(one->path.ps > 1e12);
  CHECK(one->hz == 1);
}
