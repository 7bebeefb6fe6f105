#include "hw/bit_serial_memory/figures.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "tests/support/figure_ranges.h"
#include "tests/support/test.h"

using namespace csgsim;

// Valid ranges of the parameters in a memory's file: each parameter at its minimum and maximum and just beyond, and one
// refusal for each inconsistent combination.

namespace {

constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t most_energy = million * million;

// 512 x 512 pixels with 256 bits each need 391 rows of a subarray, and 4 of the 128 subarrays of a bank.
constexpr auto ranges = std::to_array<testing::FigureRange>({
    {"picture.width", 1, 16'384},
    {"picture.height", 1, 16'384},
    {"array.memory_bits", 1, 4096, "+chips.rows=65536"},
    {"clock.frequency", 1, 10'000 * million},
    {"logic.enable", 0, 1},
    {"global_or.present", 0, 1},
    {"evaluator.degree", 1, 2, "+logic.expressions=trees"},
    {"chips.count", 1, 64},
    {"chips.banks", 1, 64},
    {"chips.subarrays", 1, 4096},
    {"chips.columns", 1, 65'536, "+chips.subarrays=4096"},
    {"bus.bits", 1, 65'536},
    {"host.plane_bits", 1, 1 << 30},
    {"timing.restore", 1, million},
    {"timing.precharge", 1, million},
    {"timing.second", 1, million},
    {"timing.logic", 1, million},
    {"timing.column", 1, million},
    {"timing.recovery", 0, million},
    {"timing.leaf", 1, million},
    {"timing.global_or", 1, million},
    {"timing.activation_gap", 1, million},
    {"timing.window", 0, million},
    {"timing.refresh_interval", 0, million},
    {"timing.refresh", 0, million, "+timing.refresh_interval=0"},
    {"energy.activation", 0, most_energy},
    {"energy.further_row", 0, 10'000},
    {"energy.logic", 0, most_energy},
    {"energy.leaf", 0, most_energy},
    {"energy.transfer", 0, most_energy},
    {"energy.refresh", 0, most_energy},
    {"energy.background", 0, most_energy},
    {"link.width", 1, 256},
    {"link.word_clocks", 1, million},
    {"link.latency", 0, million},
    {"controller.queue", 1, 65'536},
    {"host.count", 1, 4096},
});

/// Error of the memory with these changes; empty if it is valid.
std::string refusal(const std::string& changes) {
  return testing::error_of([&] { kinds::load("digital-bit-serial-ddr4" + changes); });
}

}  // namespace

TEST_CASE("each parameter of a memory accepts its limits and rejects values beyond") {
  testing::check_figure_ranges("digital-bit-serial-ddr4", ranges,
                               [](const std::string& machine) { return kinds::load(machine); });
  CHECK(refusal("+chips.rows=65536") == "");
  CHECK(refusal("+chips.rows=65537").find("chips.rows is 65537;") != std::string::npos);
  CHECK(refusal("+chips.rows=1").find("need 391 rows") != std::string::npos);
  CHECK(refusal("+chips.rows=0").find("chips.rows is 0;") != std::string::npos);
  // All keys of the kind, including three whose values are names.
  CHECK(kinds::load("digital-bit-serial-ddr4").kind->schema.size() == ranges.size() + 1 + 3);
}

TEST_CASE("ideal parameters of a memory impose no limit and others cannot be ideal") {
  for (const std::string key : {"host.plane_bits", "timing.window", "timing.refresh_interval", "controller.queue",
                                "link.width", "link.latency", "host.processor"}) {
    CAPTURE(key);
    CHECK(refusal("+" + key + "=ideal") == "");
  }
  const auto ideal = [](const std::string& key) {
    const machines::Machine machine = kinds::load("digital-bit-serial-ddr4+" + key + "=ideal");
    return machines::kind_figures<bit_serial_memory::Figures>(machine);
  };
  CHECK(ideal("host.plane_bits").plane_bits == 1U << 30U);
  CHECK(ideal("timing.window").rank.window == 0);
  CHECK(ideal("timing.refresh_interval").rank.refresh_interval == 0);
  CHECK(ideal("controller.queue").queue == 65'536);
  for (const std::string key : {"timing.restore", "timing.activation_gap", "timing.refresh", "energy.leaf"}) {
    CAPTURE(key);
    CHECK_FALSE(refusal("+" + key + "=ideal").empty());
  }
}

TEST_CASE("rejects a memory whose refreshes take half of the time or more") {
  CHECK(refusal("+timing.refresh_interval=841") == "");  // tRFC 420
  CHECK(refusal("+timing.refresh_interval=840").find("timing.refresh_interval") != std::string::npos);
  CHECK(refusal("+timing.refresh=4679") == "");  // tREFI 9360
  CHECK(refusal("+timing.refresh=4680").find("use more than twice timing.refresh") != std::string::npos);
  CHECK(refusal("+timing.refresh=4680+timing.refresh_interval=ideal") == "");
}

TEST_CASE("rejects squares on a memory with rows of x and y") {
  CHECK(refusal("+evaluator.degree=2").find("set evaluator.degree to 1, or logic.expressions to trees") !=
        std::string::npos);
  CHECK(refusal("+evaluator.degree=2+logic.expressions=planes") == "");
  CHECK(refusal("+evaluator.degree=2+logic.expressions=trees") == "");
}

TEST_CASE("rejects a memory whose pixel memory and auxiliary rows exceed a subarray") {
  // 256 rows of memory, 15 + 62 + 40 auxiliary rows, and 9 each for x and y.
  CHECK(refusal("+chips.rows=391") == "");
  CHECK(refusal("+chips.rows=390")
            .find("need 391 rows, including those for instructions; reduce "
                  "array.memory_bits, or set chips.rows to at least 391") != std::string::npos);
  CHECK(refusal("+array.memory_bits=377") == "");
  CHECK(refusal("+array.memory_bits=378").find("need 513 rows") != std::string::npos);
  CHECK(refusal("+chips.rows=391+picture.width=513").find("need 392 rows") != std::string::npos);
  CHECK(refusal("+chips.rows=391+picture.height=513").find("need 392 rows") != std::string::npos);
}

TEST_CASE("rejects a picture that exceeds the subarrays of all banks") {
  // 262,144 pixels in rows of 8,192 need 32 subarrays.
  CHECK(refusal("+chips.count=1+chips.banks=1+chips.subarrays=32") == "");
  CHECK(
      refusal("+chips.count=1+chips.banks=1+chips.subarrays=31")
          .ends_with("a picture of 512x512 needs 32 subarrays of each chip, but digital-bit-serial-ddr4 has 31; use a "
                     "smaller picture, or increase chips.subarrays in the machine file"));
  CHECK(refusal("+chips.count=1+chips.banks=2+chips.subarrays=16") == "");
  CHECK_FALSE(refusal("+chips.count=1+chips.banks=2+chips.subarrays=15").empty());
  CHECK(refusal("+chips.count=2+chips.banks=1+chips.subarrays=16") == "");
  machines::Machine full = kinds::load("digital-bit-serial-ddr4+chips.count=1+chips.banks=1+chips.subarrays=32");
  CHECK_NOTHROW(machines::set_picture_size(full, {256, 1024}));
  CHECK(full.array.width == 256);
  CHECK(full.array.height == 1024);
  CHECK_THROWS_WITH_AS(machines::set_picture_size(full, {512, 513}), doctest::Contains("a picture of 512x513 needs 33"),
                       InputError);
}

TEST_CASE("a memory that computes has one processor per pixel of the picture") {
  const machines::Machine machine = kinds::load("digital-bit-serial-ddr4+picture.width=300+array.memory_bits=100");
  const machines::Resources resources = machine.kind->resources(machine, {});
  CHECK(resources.processors == 300 * 512);
  CHECK(resources.memory_bits == 300 * 512 * 100);
  CHECK(machine.kind->regions(machine) == std::vector<isa::Region>{{0, 0, 300, 512}});
}

TEST_CASE("a memory accepts Programs of its picture size with at most its pixel memory") {
  const machines::Machine machine = kinds::load("digital-bit-serial-ddr4");
  CHECK(machine.kind->has_global_or(machine));
  isa::Program program;
  program.shape = {64, 48, 256};
  program.segments.push_back({.region = {0, 0, 64, 48}, .instructions = {{.opcode = isa::Opcode::skip_if_none}}});
  const auto refused = [&] { return testing::error_of([&] { machine.kind->check(program, machine); }); };
  CHECK(refused() == "");
  program.shape.memory_bits = 257;
  CHECK(refused().find("257 bits") != std::string::npos);
  program.shape.memory_bits = 256;
  program.segments.front().region.width = 32;
  CHECK(refused().find("are not the 1 regions") != std::string::npos);
}