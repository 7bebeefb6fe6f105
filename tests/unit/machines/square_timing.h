#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hw/division/encoding.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/timing.h"
#include "tests/unit/division/hand_models.h"

/// Pixel-square machines and Programs with hand-counted clocks.
namespace csgsim::testing::squares {

using isa::Field;
using isa::Instruction;
using isa::Opcode;
using machines::Machine;
using pixel_square::Figures;
using Timing = pixel_square::SquareTiming;

/// Clocks of a part by activity: working, waiting for host, divider, renderer, frame buffer, done.
using Clocks = pixel_square::SquareClocks;

/// A link that carries every command of these tests in one word.
inline constexpr machines::Link wide{.width = 256, .word_clocks = 1, .fifo_depth = 1000, .latency = 0};

inline Machine make_machine(std::uint32_t side, Figures figures, machines::Link link = wide) {
  Machine machine = machines::blank_machine(pixel_square::kind);
  machine.name = "squares";
  machine.array = {side, side, 16};
  machine.picture = {4, 4};
  machine.link = link;
  machine.own = figures;
  return machine;
}

inline const Instruction enable{.opcode = Opcode::enable_all};

inline Instruction set(Field field) { return {.opcode = Opcode::set_constant, .fields = {field}}; }

inline isa::Program make_program(std::uint16_t colour_bits, std::vector<isa::Segment> segments) {
  isa::Program program;
  program.shape = {4, 4, 16};
  program.colour = {0, colour_bits};
  program.segments = std::move(segments);
  return program;
}

inline isa::Segment square(std::uint32_t side, std::vector<Instruction> instructions) {
  return {.region = {0, 0, side, side}, .instructions = std::move(instructions)};
}

inline Timing time(const isa::Program& program, const Machine& machine) {
  return pixel_square::time_squares(program, machine);
}

/// Returns a model of two primitives and three nodes. By docs/machines/pixel-square.md its records have 77 bits (a
/// primitive), 6 (a half-space) and 8 (a plane).
inline std::vector<std::uint8_t> model_bytes() {
  std::vector<std::uint8_t> bytes;
  for (const isa::LinkWord& byte : division::to_link(division::encode(slab_with_hole()), 8))
    bytes.push_back(static_cast<std::uint8_t>(byte.number(0, 8)));
  return bytes;
}

/// Figures of a machine with dividers; a port of 80 bits reads each record in one clock.
inline Figures dividing() {
  return {.port_bits = 64,
          .divider = pixel_square::DividerKind::corners,
          .model_bits = 1'000'000,
          .record_bits = 80,
          .halfspaces = 1000,
          .nodes = 1000,
          .store_words = 1000,
          .halfspace_clocks = 4};
}

/// Returns the figures with dividing graphics processors.
inline Figures on_a_ring(Figures figures) {
  figures.divider = pixel_square::DividerKind::processors;
  return figures;
}

}  // namespace csgsim::testing::squares
