#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/bit_serial_memory/bank.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::bit_serial_memory {

/// The pixels of the picture, read from the rows of all banks.
class MemoryView final : public systemc::PixelView {
 public:
  /// The banks must outlive the view. `enable_in_latch`: E is in a latch instead of a row.
  MemoryView(std::span<const Bank* const> banks, const Slots& slots, std::uint32_t picture_width, const RowMap& map,
             bool enable_in_latch);

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override;
  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override;
  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override;

  [[nodiscard]] std::uint64_t count_enabled() const;
  [[nodiscard]] bool enabled(std::uint64_t pixel) const;
  [[nodiscard]] bool bit(Row row, std::uint64_t pixel) const;

 private:
  [[nodiscard]] std::span<const std::uint64_t> enable_words(std::uint64_t slot) const;

  std::span<const Bank* const> banks_;
  Slots slots_;
  std::uint32_t picture_width_;
  RowMap map_;
  bool enable_in_latch_;
};

}  // namespace csgsim::bit_serial_memory
