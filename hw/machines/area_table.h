// Synthesized transistor counts.
// Used by area.cpp and hw/process.
#pragma once

#include <array>
#include <cstdint>

// Written by tests/rtl/area.py from Yosys's synthesis of the Verilog in hw/rtl: transistors of static CMOS.
namespace csgsim::machines {

/// A pixel processor with its registers and the rotators of its memory ports, without its memory; in degree 2 with the
/// flag for roots.
struct PixelLogic {
  std::uint32_t alu_bits;
  std::uint32_t memory_reads;
  std::uint32_t degree;
  std::uint32_t transistors;
};

// clang-format off
inline constexpr auto pixel_logic_table = std::to_array<PixelLogic>({
    {1, 1, 1, 344},
    {1, 2, 1, 298},
    {2, 1, 1, 580},
    {2, 2, 1, 496},
    {4, 1, 1, 1070},
    {4, 2, 1, 934},
    {8, 1, 1, 2106},
    {8, 2, 1, 1964},
    {16, 1, 1, 4370},
    {16, 2, 1, 4262},
    {32, 1, 1, 9178},
    {32, 2, 1, 9328},
    {1, 1, 2, 392},
    {1, 2, 2, 350},
    {2, 1, 2, 636},
    {2, 2, 2, 546},
    {4, 1, 2, 1154},
    {4, 2, 2, 1052},
    {8, 1, 2, 2234},
    {8, 2, 2, 2158},
    {16, 1, 2, 4610},
    {16, 2, 2, 4590},
    {32, 1, 2, 9638},
    {32, 2, 2, 10044},
});
// clang-format on

/// A node of the multiplier trees with that degree (1 or 2) and stream width; there is one per pixel.
struct NodeLogic {
  std::uint32_t bits;
  std::uint32_t degree;
  std::uint32_t transistors;
};

// clang-format off
inline constexpr auto node_logic_table = std::to_array<NodeLogic>({
    {1, 1, 90},
    {2, 1, 158},
    {4, 1, 294},
    {8, 1, 560},
    {16, 1, 1092},
    {32, 1, 2170},
    {1, 2, 258},
    {2, 2, 431},
    {4, 2, 801},
    {8, 2, 1525},
    {16, 2, 2950},
    {32, 2, 5797},
});
// clang-format on

/// The controller with its receiver, and the link's FIFO with fifo_bits bits, both for the parameters of
/// pixel-planes-4.
inline constexpr std::uint32_t controller_transistors = 37802;
inline constexpr std::uint32_t fifo_transistors = 19644;
inline constexpr std::uint32_t fifo_bits = 512;

}  // namespace csgsim::machines
