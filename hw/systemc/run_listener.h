// Interface for observers of a run.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/scan_line, sim/cycle and sim/waves.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/machines/run_outcome.h"

namespace csgsim::systemc {

/// An instruction that the pixels of a segment have just executed.
struct Retired {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;                           ///< index within the segment
  std::uint64_t clocks = 0;                          ///< clocks of the unit that issues instructions
  std::uint64_t enabled_pixels = 0;                  ///< pixels with E = 1 when the instruction began
  std::uint64_t skipped = 0;                         ///< number of instructions that this one skips
  std::optional<machines::PixelClocks> at_pixels{};  ///< set if the clocks differ between pixels
};

/// The part of the pixels' state that a PixelView must provide.
enum class Keep : std::uint8_t { nothing, enable, all };

/// The pixels of a region after an instruction; (0, 0) is the region's top left pixel. Valid only during the call to
/// which it is passed. Reading state that RunListener::required_after did not request may throw std::logic_error.
class PixelView {
 public:
  virtual ~PixelView() = default;

  /// Reads the field at every pixel, in row order; `values` has width * height elements.
  virtual void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                          std::span<std::uint32_t> values) const = 0;

  /// Reads the enable bits: pixel x of a row is bit x % 64 of word x / 64; rows are padded to whole words with zeros;
  /// `words` has ceil(width / 64) * height elements. Pixels right of the segment's region or below it are disabled.
  virtual void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const = 0;

  /// A permanent copy of the pixels.
  [[nodiscard]] virtual std::unique_ptr<const PixelView> copy() const = 0;
};

/// Observes a run. Calls are in order within a segment; segments that are drawn in parallel are interleaved.
class RunListener {
 public:
  virtual ~RunListener() = default;

  /// The state that the view after the given instruction must provide; queried before the instruction is sent. Machines
  /// may provide more.
  [[nodiscard]] virtual Keep required_after(std::uint32_t /*segment*/, std::uint32_t /*index*/) {
    return Keep::nothing;
  }
  virtual void after_instruction(const Retired& /*retired*/, const PixelView& /*pixels*/) {}

  /// Called once per segment, even without instructions. The view provides all state.
  virtual void after_segment(std::uint32_t /*segment*/, const PixelView& /*pixels*/) {}
};

}  // namespace csgsim::systemc
