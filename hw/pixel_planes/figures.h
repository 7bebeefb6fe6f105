#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::pixel_planes {

/// Where a row's colour bits are read.
enum class ScanOutPort : std::uint8_t {
  own,     ///< a read port of pixel memory that nothing else uses
  shared,  ///< that of the pixels' ALU, in a clock in which the controller sends a refresh word
};

inline constexpr auto scan_out_port_names = std::to_array<std::string_view>({"own", "shared"});

/// What only this kind of machine has.
struct Figures {
  bool has_global_or = true;    ///< the controller learns whether any pixel is enabled
  std::uint32_t or_fan_in = 0;  ///< inputs of a gate of that OR; 0: one gate has all, and settles within the clock
  std::uint32_t scan_out_pixels = 1;  ///< shown a clock
  ScanOutPort scan_out_port = ScanOutPort::own;
  /// Pictures that a pixel's memory holds: with 2, a finished one is copied into the topmost bits, and shown from there
  /// while the next is drawn.
  std::uint32_t scan_out_buffers = 1;
};

}  // namespace csgsim::pixel_planes
