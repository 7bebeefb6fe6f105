// Parameters that only frame-buffer machines have.
// Used by hw/pixel_planes, sim/rtl and tests.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::pixel_planes {

/// Port through which the scan-out reads the colour bits of a row.
enum class ScanOutPort : std::uint8_t {
  own,     ///< a separate read port of pixel memory
  shared,  ///< the read port of the pixels' ALU, in clocks in which the controller sends a refresh word
};

inline constexpr auto scan_out_port_names = std::to_array<std::string_view>({"own", "shared"});

/// Parameters that only this kind of machine has.
struct Figures {
  bool has_global_or = true;    ///< whether the controller can test if any pixel is enabled
  std::uint32_t or_fan_in = 0;  ///< inputs per gate of the global OR; 0: a single gate that settles within the clock
  std::uint32_t scan_out_pixels = 1;  ///< pixels shown per clock
  ScanOutPort scan_out_port = ScanOutPort::own;
  /// Pictures in pixel memory. With 2, a finished picture is copied into the topmost bits and displayed from there
  /// while the next is drawn.
  std::uint32_t scan_out_buffers = 1;
};

}  // namespace csgsim::pixel_planes
