#include "hw/bit_serial_memory/memory_view.h"

#include <algorithm>
#include <bit>
#include <memory>

namespace csgsim::bit_serial_memory {

namespace {

/// Copy of the values of all pixels; fields are assembled on demand.
class Snapshot final : public systemc::PixelView {
 public:
  Snapshot(const MemoryView& view, const RowMap& map, std::uint64_t pixels, std::uint32_t picture_width)
      : picture_width_(picture_width), enable_(pixels) {
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) enable_[pixel] = view.enabled(pixel);
    rows_.assign(map.memory_bits, std::vector<bool>(pixels));
    for (unsigned row = 0; row < map.memory_bits; ++row) {
      for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) rows_[row][pixel] = view.bit(static_cast<Row>(row), pixel);
    }
  }

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override {
    std::size_t next = 0;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x, ++next) {
        values[next] = 0;
        for (unsigned i = 0; i < field.width; ++i)
          values[next] |= static_cast<std::uint32_t>(rows_[field.base + i][pixel(x, y)]) << i;
      }
    }
  }

  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override {
    const std::size_t row_words = (width + 63U) / 64U;
    std::ranges::fill(words, 0U);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        if (enable_[pixel(x, y)]) words[y * row_words + x / 64] |= std::uint64_t{1} << x % 64;
      }
    }
  }

  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override { return std::make_unique<Snapshot>(*this); }

 private:
  [[nodiscard]] std::uint64_t pixel(std::uint32_t x, std::uint32_t y) const {
    return std::uint64_t{y} * picture_width_ + x;
  }

  std::uint32_t picture_width_;
  std::vector<bool> enable_;
  std::vector<std::vector<bool>> rows_;
};

bool bit_of(std::span<const std::uint64_t> words, std::uint64_t column) {
  return (words[column / 64] >> column % 64 & 1U) != 0;
}

}  // namespace

MemoryView::MemoryView(std::span<const Bank* const> banks, const Slots& slots, std::uint32_t picture_width,
                       const RowMap& map, bool enable_in_latch)
    : banks_(banks), slots_(slots), picture_width_(picture_width), map_(map), enable_in_latch_(enable_in_latch) {}

std::span<const std::uint64_t> MemoryView::enable_words(std::uint64_t slot) const {
  const Subarray& subarray = banks_[slots_.bank(slot)]->subarray(slot);
  return enable_in_latch_ ? subarray.latch(Latch::enable) : subarray.row(map_.enable());
}

bool MemoryView::enabled(std::uint64_t pixel) const {
  return bit_of(enable_words(pixel / slots_.row_columns), pixel % slots_.row_columns);
}

bool MemoryView::bit(Row row, std::uint64_t pixel) const {
  const std::uint64_t slot = pixel / slots_.row_columns;
  return bit_of(banks_[slots_.bank(slot)]->subarray(slot).row(row), pixel % slots_.row_columns);
}

/// Bits of columns after the last pixel are ignored, since they are undefined.
std::uint64_t MemoryView::count_enabled() const {
  std::uint64_t count = 0;
  for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) {
    const std::span<const std::uint64_t> words = enable_words(slot);
    const std::uint64_t columns = slots_.columns(slot);
    for (std::size_t word = 0; word < words.size(); ++word) {
      const std::uint64_t left = columns - word * 64;
      const std::uint64_t valid = left >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1;
      count += static_cast<std::uint64_t>(std::popcount(words[word] & valid));
    }
  }
  return count;
}

void MemoryView::read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                            std::span<std::uint32_t> values) const {
  std::ranges::fill(values, 0U);
  for (unsigned i = 0; i < field.width; ++i) {
    std::size_t next = 0;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x, ++next) {
        const std::uint64_t pixel = std::uint64_t{y} * picture_width_ + x;
        values[next] |= static_cast<std::uint32_t>(bit(static_cast<Row>(field.base + i), pixel)) << i;
      }
    }
  }
}

void MemoryView::read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const {
  const std::size_t row_words = (width + 63U) / 64U;
  std::ranges::fill(words, 0U);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      if (enabled(std::uint64_t{y} * picture_width_ + x)) words[y * row_words + x / 64] |= std::uint64_t{1} << x % 64;
    }
  }
}

std::unique_ptr<const systemc::PixelView> MemoryView::copy() const {
  return std::make_unique<Snapshot>(*this, map_, slots_.pixels, picture_width_);
}

}  // namespace csgsim::bit_serial_memory
