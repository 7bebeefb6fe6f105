#include "hw/machines/schema.h"

#include <array>
#include <type_traits>

namespace csgsim::machines {

namespace {

constexpr Kinds every_kind{};
constexpr Kinds whole_picture{true, false, false};
constexpr Kinds bit_serial{true, false, true};
constexpr Kinds by_lines{false, true, false};
constexpr Kinds by_squares{false, false, true};
constexpr Kinds in_parts{false, true, true};

constexpr std::int64_t most_clocks = 1'000'000;

/// For figures that have one value only, which the simulator builds in.
void store_nothing(Machine& /*machine*/, std::int64_t /*value*/) {}

/// Puts the value into a member of the machine, or into a member of one of its parts.
template <auto... members>
void store(Machine& machine, std::int64_t value) {
  auto& member = (machine.*....*members);
  member = static_cast<std::remove_reference_t<decltype(member)>>(value);
}

constexpr auto table = std::to_array<FigureSchema>({
    {bit_serial, "array.width", "pixels", 1, isa::max_array_side, "pixel processors in a row",
     [](Machine& machine, std::int64_t value) { machine.array.width = static_cast<std::uint32_t>(value); }},
    {bit_serial, "array.height", "pixels", 1, isa::max_array_side, "rows of pixel processors",
     [](Machine& machine, std::int64_t value) { machine.array.height = static_cast<std::uint32_t>(value); }},
    {bit_serial, "array.memory_bits", "bits", 1, isa::max_memory_bits, "memory of a pixel processor",
     [](Machine& machine, std::int64_t value) { machine.array.memory_bits = static_cast<std::uint32_t>(value); }},
    {by_lines, "cells.count", "cells", 1, isa::max_array_side, "cells of a chain, one a pixel of a line",
     [](Machine& machine, std::int64_t value) { machine.array.width = static_cast<std::uint32_t>(value); }},
    {by_lines, "cells.words", "words", 1, 64, "memory of a cell", store<&Machine::scan_line, &ScanLine::words>},
    {by_lines, "cells.word_bits", "bits", 1, 64, "width of the cells' words and adders",
     store<&Machine::scan_line, &ScanLine::word_bits>},
    {in_parts, "picture.width", "pixels", 1, isa::max_array_side, "width of the picture",
     store<&Machine::picture, &Size::width>},
    {in_parts, "picture.height", "pixels", 1, isa::max_array_side, "height of the picture",
     store<&Machine::picture, &Size::height>},
    {every_kind, "clock.frequency", "Hz", 1, 1'000'000'000, "steps a second", store<&Machine::clock_hz>},
    {bit_serial, "memory.reads", "a clock", 1, 2, "reads of a pixel's memory", store<&Machine::memory_reads>},
    {bit_serial, "memory.writes", "a clock", 1, 1, "writes of a pixel's memory", store_nothing},
    {bit_serial, "alu.bits", "bits", 1, isa::max_field_width, "bits of a field that the ALU works on in a clock",
     store<&Machine::alu_bits>},
    {whole_picture, "global_or.present", "lines", 0, 1, "wired OR of all enable bits, back to the controller",
     store<&Machine::has_global_or>},
    {bit_serial, "evaluator.level_latency", "clocks", 1, 1, "from one level of a multiplier tree to the next",
     store_nothing},
    {by_lines, "chains.count", "chains", 1, 1024, "lines worked on in parallel",
     store<&Machine::scan_line, &ScanLine::chains>},
    {by_lines, "packets.interval", "clocks", 1, most_clocks, "from the entry of one packet to that of the next",
     store<&Machine::scan_line, &ScanLine::packet_interval>},
    {by_lines, "refresh.rate", "Hz", 1, 1000, "fields shown a second",
     store<&Machine::scan_line, &ScanLine::refresh_hz>},
    {by_lines, "refresh.interlaced", "", 0, 1, "1: a field is every other line",
     store<&Machine::scan_line, &ScanLine::interlaced>},
    {by_squares, "renderers.count", "renderers", 1, 1024, "squares drawn in parallel",
     store<&Machine::pixel_square, &PixelSquare::renderers>},
    {by_squares, "renderers.buffers", "squares", 1, 2, "finished or unfinished squares that a renderer holds",
     store<&Machine::pixel_square, &PixelSquare::buffers>},
    {by_squares, "fifo.depth", "words", 1, most_clocks, "of every FIFO between two parts",
     store<&Machine::pixel_square, &PixelSquare::fifo_depth>},
    {by_squares, "port.width", "bits", 1, 65536, "colour bits that the frame buffer takes in a clock",
     store<&Machine::pixel_square, &PixelSquare::port_bits>},
    {by_squares, "host.word_clocks", "clocks", 1, most_clocks,
     "from one word of the model to the next; a primitive and a half-space are a word each",
     store<&Machine::pixel_square, &PixelSquare::host_word_clocks>},
    {by_squares, "divider.primitive_clocks", "clocks", 0, most_clocks,
     "to hold the bounds of a primitive against a square",
     store<&Machine::pixel_square, &PixelSquare::primitive_clocks>},
    {by_squares, "divider.halfspace_clocks", "clocks", 0, most_clocks,
     "to hold a half-space against the corners of a square",
     store<&Machine::pixel_square, &PixelSquare::halfspace_clocks>},
    {by_squares, "divider.order", "", 0, 2, "in which squares are drawn",
     store<&Machine::pixel_square, &PixelSquare::order>, square_order_names},
});

}  // namespace

std::span<const FigureSchema> schema() { return table; }

}  // namespace csgsim::machines
