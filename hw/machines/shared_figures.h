// Parameters shared by several kinds.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include "hw/isa/instruction.h"
#include "hw/isa/link_word.h"
#include "hw/machines/schema.h"

// Rows of the schema shared by several kinds of machines.
namespace csgsim::machines::shared {

inline constexpr std::int64_t max_register_levels = 16;

inline constexpr FigureSchema array_width = figure<&Machine::array, &isa::ArrayShape::width>(
    "array.width", "pixels", 1, isa::max_array_side, "pixel processors in a row");
inline constexpr FigureSchema array_height = figure<&Machine::array, &isa::ArrayShape::height>(
    "array.height", "pixels", 1, isa::max_array_side, "rows of pixel processors");
inline constexpr FigureSchema memory_bits = figure<&Machine::array, &isa::ArrayShape::memory_bits>(
    "array.memory_bits", "bits", 1, isa::max_memory_bits, "memory of a pixel processor");
inline constexpr FigureSchema picture_width =
    figure<&Machine::picture, &Size::width>("picture.width", "pixels", 1, isa::max_array_side, "width of the picture");
inline constexpr FigureSchema picture_height = figure<&Machine::picture, &Size::height>(
    "picture.height", "pixels", 1, isa::max_array_side, "height of the picture");
inline constexpr FigureSchema clock_frequency =
    figure<&Machine::clock_hz>("clock.frequency", "Hz", 1, 10'000'000'000, "clocks per second");
inline constexpr FigureSchema memory_reads =
    figure<&Machine::memory_reads>("memory.reads", "a clock", 1, 2, "read ports of a pixel's memory");
inline constexpr FigureSchema memory_writes =
    built_in_figure("memory.writes", "a clock", 1, "write ports of a pixel's memory");
inline constexpr FigureSchema alu_bits = figure<&Machine::alu_bits>("alu.bits", "bits", 1, isa::max_field_width,
                                                                    "bits of a field that the ALU processes per clock");
inline constexpr FigureSchema level_latency = built_in_figure(
    "evaluator.level_latency", "clocks", 1, "clocks from one register of a multiplier tree to the next");
inline constexpr FigureSchema register_levels =
    figure<&Machine::register_levels>("evaluator.register_levels", "levels", 1, max_register_levels,
                                      "tree levels from one register to the next; the last level has registers");
inline constexpr FigureSchema evaluator_bits =
    figure<&Machine::evaluator_bits>("evaluator.bits", "bits", 1, isa::max_field_width,
                                     "bits of an expression that the trees deliver per clock, at most alu.bits");
inline constexpr FigureSchema evaluator_degree = figure<&Machine::evaluator_degree>(
    "evaluator.degree", "", 1, 2, "degree of the expressions: 1 for A*x + B*y + C, 2 to add A*x*x + B*x*y + C*y*y");

inline constexpr FigureSchema clear_clocks =
    or_ideal(figure<&Machine::clear_clocks>("memory.clear_clocks", "clocks", 0, max_parameter_clocks,
                                            "clocks to clear all memory of the pixel processors when a segment begins"),
             0);
inline constexpr FigureSchema host_processor = or_ideal(
    with_names(
        figure<&Machine::host, &Host::processor>("host.processor", "", 0, std::int64_t{host_processor_names.size()} - 1,
                                                 "processor that compiles a frame while the previous is drawn"),
        host_processor_names),
    ideal_processor);
inline constexpr FigureSchema host_count =
    figure<&Machine::host, &Host::count>("host.count", "processors", 1, 4096, "processors that share this work");
inline constexpr FigureSchema link_width =
    or_ideal(figure<&Machine::link, &Link::width>("link.width", "bits", 1, isa::LinkWord::max_bits,
                                                  "bits of a word of the link"),
             isa::LinkWord::max_bits);
inline constexpr FigureSchema link_word_clocks = figure<&Machine::link, &Link::word_clocks>(
    "link.word_clocks", "clocks", 1, max_parameter_clocks, "clocks from one word of the link to the next");
inline constexpr FigureSchema link_fifo_depth =
    or_ideal(figure<&Machine::link, &Link::fifo_depth>("link.fifo_depth", "words", 1, 65536,
                                                       "words in the FIFO at the machine's end of the link"),
             65536);
inline constexpr FigureSchema link_latency =
    or_ideal(figure<&Machine::link, &Link::latency>("link.latency", "clocks", 0, max_parameter_clocks,
                                                    "clocks from a request (frame start or jump) to the first word"),
             0);

}  // namespace csgsim::machines::shared
