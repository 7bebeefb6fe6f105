#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/machines/told.h"

/// What a machine in SystemC tells of a run while it goes by.
namespace csgsim::systemc {

/// An instruction that the pixels of a segment have just carried out.
struct Retired {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;                           ///< within the segment
  std::uint64_t clocks = 0;                          ///< that it took of what hands out instructions
  std::uint64_t enabled_pixels = 0;                  ///< pixels whose E was 1 when the instruction began
  std::uint64_t skipped = 0;                         ///< instructions after it that are not carried out
  std::optional<machines::PixelClocks> at_pixels{};  ///< where it does not take the same at each pixel
};

/// What of the pixels a view has to show.
enum class Keep : std::uint8_t { nothing, enable, all };

/// The pixels of a region whose top left is the array's corner, as an instruction left them. Valid during the call
/// that it comes with. Where RunListener::keeps_after did not ask for what is read, it may throw std::logic_error.
class PixelView {
 public:
  virtual ~PixelView() = default;

  /// The field's value at every pixel, in row order; `values` holds width * height of them.
  virtual void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                          std::span<std::uint32_t> values) const = 0;

  /// Enable bits: pixel x of a row is bit x % 64 of word x / 64, each row padded to whole words with zeros; `words`
  /// holds ceil(width / 64) * height of them. No pixel right of the segment's region or below it is enabled.
  virtual void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const = 0;

  /// The same pixels, to be looked at later.
  [[nodiscard]] virtual std::unique_ptr<const PixelView> copy() const = 0;
};

/// Sees a run go by: in order within a segment, but segments that are drawn side by side come interleaved.
class RunListener {
 public:
  virtual ~RunListener() = default;

  /// What the view after that instruction has to show, asked before the instruction is sent; a machine may show more.
  [[nodiscard]] virtual Keep keeps_after(std::uint32_t /*segment*/, std::uint32_t /*index*/) { return Keep::nothing; }
  virtual void after_instruction(const Retired& /*retired*/, const PixelView& /*pixels*/) {}

  /// Once a segment, also for one without instructions. The view shows all.
  virtual void after_segment(std::uint32_t /*segment*/, const PixelView& /*pixels*/) {}
};

}  // namespace csgsim::systemc
