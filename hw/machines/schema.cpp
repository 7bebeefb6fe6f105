#include "hw/machines/schema.h"

#include <array>

namespace csgsim::machines {

namespace {

/// For figures that have one value only, which the simulator builds in.
void store_nothing(Machine& /*machine*/, std::int64_t /*value*/) {}

constexpr auto table = std::to_array<FigureSchema>({
    {"array.width", "pixels", 1, isa::max_array_side, "pixel processors in a row",
     [](Machine& machine, std::int64_t value) { machine.array.width = static_cast<std::uint32_t>(value); }},
    {"array.height", "pixels", 1, isa::max_array_side, "rows of pixel processors",
     [](Machine& machine, std::int64_t value) { machine.array.height = static_cast<std::uint32_t>(value); }},
    {"array.memory_bits", "bits", 1, isa::max_memory_bits, "memory of a pixel processor",
     [](Machine& machine, std::int64_t value) { machine.array.memory_bits = static_cast<std::uint32_t>(value); }},
    {"clock.frequency", "Hz", 1, 1'000'000'000, "instruction bit steps a second",
     [](Machine& machine, std::int64_t value) { machine.clock_hz = static_cast<std::uint64_t>(value); }},
    {"memory.reads", "a clock", 1, 2, "reads of a pixel's memory",
     [](Machine& machine, std::int64_t value) { machine.memory_reads = static_cast<std::uint32_t>(value); }},
    {"memory.writes", "a clock", 1, 1, "writes of a pixel's memory", store_nothing},
    {"global_or.present", "lines", 0, 1, "wired OR of all enable bits, back to the controller",
     [](Machine& machine, std::int64_t value) { machine.has_global_or = value != 0; }},
    {"evaluator.level_latency", "clocks", 1, 1, "from one level of a multiplier tree to the next", store_nothing},
});

}  // namespace

std::span<const FigureSchema> schema() { return table; }

}  // namespace csgsim::machines
