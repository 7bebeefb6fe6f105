// Synthesized transistor counts.
// Used by area.cpp and hw/process.
#pragma once

#include <array>
#include <cstdint>

// Written by tests/rtl/area.py from Yosys's synthesis of the Verilog in hw/rtl.
namespace csgsim::machines {

/// Transistors of a circuit in static CMOS, and in nMOS with depletion loads, dynamic latches and pass-transistor
/// selectors (tests/rtl/nmos.lib).
struct Transistors {
  std::uint32_t cmos;
  std::uint32_t nmos;
};

/// A pixel processor with its registers and the rotators of its memory ports, without its memory; in degree 2 with the
/// flag for roots.
struct PixelLogic {
  std::uint32_t alu_bits;
  std::uint32_t memory_reads;
  std::uint32_t degree;
  Transistors transistors;
};

// clang-format off
inline constexpr auto pixel_logic_table = std::to_array<PixelLogic>({
    {1, 1, 1, {344, 217}},
    {1, 2, 1, {298, 188}},
    {2, 1, 1, {580, 371}},
    {2, 2, 1, {496, 305}},
    {4, 1, 1, {1070, 666}},
    {4, 2, 1, {934, 564}},
    {8, 1, 1, {2106, 1260}},
    {8, 2, 1, {1964, 1096}},
    {16, 1, 1, {4370, 2520}},
    {16, 2, 1, {4262, 2252}},
    {32, 1, 1, {9178, 5071}},
    {32, 2, 1, {9328, 4749}},
    {1, 1, 2, {392, 246}},
    {1, 2, 2, {350, 215}},
    {2, 1, 2, {636, 396}},
    {2, 2, 2, {546, 340}},
    {4, 1, 2, {1154, 718}},
    {4, 2, 2, {1052, 655}},
    {8, 1, 2, {2234, 1321}},
    {8, 2, 2, {2158, 1267}},
    {16, 1, 2, {4610, 2649}},
    {16, 2, 2, {4590, 2593}},
    {32, 1, 2, {9638, 5368}},
    {32, 2, 2, {10044, 5449}},
});
// clang-format on

/// A node of the multiplier trees with that degree (1 or 2) and stream width; there is one per pixel.
struct NodeLogic {
  std::uint32_t bits;
  std::uint32_t degree;
  Transistors transistors;
};

// clang-format off
inline constexpr auto node_logic_table = std::to_array<NodeLogic>({
    {1, 1, {90, 50}},
    {2, 1, {158, 89}},
    {4, 1, {294, 167}},
    {8, 1, {560, 317}},
    {16, 1, {1092, 612}},
    {32, 1, {2170, 1223}},
    {1, 2, {258, 149}},
    {2, 2, {431, 262}},
    {4, 2, {801, 494}},
    {8, 2, {1525, 945}},
    {16, 2, {2950, 1846}},
    {32, 2, {5797, 3616}},
});
// clang-format on

/// The controller with its receiver, and the link's FIFO with fifo_bits bits, for the parameters of pixel-planes-4.
inline constexpr Transistors controller_transistors{37802, 20708};
inline constexpr Transistors fifo_transistors{19644, 7552};
inline constexpr std::uint32_t fifo_bits = 512;

}  // namespace csgsim::machines
