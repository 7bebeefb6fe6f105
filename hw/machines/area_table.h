#pragma once

#include <array>
#include <cstdint>

/// Written by tests/rtl/area.py from what Yosys makes of the Verilog in tests/rtl: transistors of static CMOS.
namespace csgsim::machines {

/// A pixel processor with its registers and the turning of its memory ports, without its memory.
struct PixelLogic {
  std::uint32_t alu_bits;
  std::uint32_t memory_reads;
  std::uint32_t transistors;
};

// clang-format off
inline constexpr auto pixel_logic_table = std::to_array<PixelLogic>({
    {1, 1, 344},
    {1, 2, 298},
    {2, 1, 580},
    {2, 2, 496},
    {4, 1, 1068},
    {4, 2, 934},
    {8, 1, 2106},
    {8, 2, 1966},
    {16, 1, 4370},
    {16, 2, 4262},
    {32, 1, 9234},
    {32, 2, 9328},
});
// clang-format on

/// A node of the multiplier trees, of which there is one a pixel.
inline constexpr std::uint32_t tree_node_transistors = 90;

}  // namespace csgsim::machines
