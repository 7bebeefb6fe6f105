#include "sim/cycle/overflow.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace csgsim::sim {

namespace {

__extension__ using Wide = __int128;

constexpr std::uint32_t word_bits = 64;

/// A rectangle of pixels; the last column and row belong to it.
struct Box {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  std::uint32_t top = 0;
  std::uint32_t bottom = 0;
};

bool fits(const isa::Linear& linear, std::uint32_t x, std::uint32_t y) {
  const Wide sum = static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
  const Wide half = static_cast<Wide>(1) << (linear.width - 1U);
  return -half <= sum && sum < half;
}

/// A linear expression has its extremes in the corners.
bool fits(const isa::Linear& linear, const Box& box) {
  return fits(linear, box.left, box.top) && fits(linear, box.right, box.top) && fits(linear, box.left, box.bottom) &&
         fits(linear, box.right, box.bottom);
}

bool any(std::span<const std::uint64_t> words) {
  return std::any_of(words.begin(), words.end(), [](std::uint64_t word) { return word != 0; });
}

/// The smallest box around the bits that are set in rows of words.
class Bounds {
 public:
  Bounds(std::span<const std::uint64_t> enable, std::size_t row_words, std::uint32_t height)
      : enable_(enable), row_words_(row_words), height_(height) {}

  [[nodiscard]] std::optional<Box> box() const {
    Box box;
    while (box.top < height_ && !any(row(box.top))) ++box.top;
    if (box.top == height_) return std::nullopt;
    box.bottom = height_ - 1;
    while (!any(row(box.bottom))) --box.bottom;
    box.left = static_cast<std::uint32_t>(row_words_) * word_bits;
    for (std::uint32_t y = box.top; y <= box.bottom; ++y) widen(box, row(y));
    return box;
  }

 private:
  [[nodiscard]] std::span<const std::uint64_t> row(std::uint32_t y) const {
    return enable_.subspan(y * row_words_, row_words_);
  }

  static void widen(Box& box, std::span<const std::uint64_t> row) {
    const auto words = static_cast<std::uint32_t>(row.size());
    for (std::uint32_t word = 0; word * word_bits < box.left && word < words; ++word) {
      if (row[word] == 0) continue;
      box.left = std::min(box.left, word * word_bits + static_cast<std::uint32_t>(std::countr_zero(row[word])));
      break;
    }
    for (std::uint32_t word = words; word * word_bits > box.right && word > 0; --word) {
      if (row[word - 1] == 0) continue;
      const auto bit = word_bits - 1 - static_cast<std::uint32_t>(std::countl_zero(row[word - 1]));
      box.right = std::max(box.right, (word - 1) * word_bits + bit);
      break;
    }
  }

  std::span<const std::uint64_t> enable_;
  std::size_t row_words_;
  std::uint32_t height_;
};

std::uint64_t count_in_row(const isa::Linear& linear, std::uint32_t y, std::span<const std::uint64_t> row) {
  std::uint64_t count = 0;
  for (std::uint32_t word = 0; word < row.size(); ++word) {
    for (std::uint64_t bits = row[word]; bits != 0; bits &= bits - 1) {
      const std::uint32_t x = word * word_bits + static_cast<std::uint32_t>(std::countr_zero(bits));
      if (!fits(linear, x, y)) ++count;
    }
  }
  return count;
}

}  // namespace

bool can_overflow(const isa::Linear& linear, const isa::Region& region) {
  return linear.width > 0 && !fits(linear, Box{0, region.width - 1, 0, region.height - 1});
}

std::uint64_t count_overflows(const isa::Linear& linear, const isa::Region& region,
                              std::span<const std::uint64_t> enable, std::size_t row_words) {
  if (!can_overflow(linear, region)) return 0;
  const std::optional<Box> box = Bounds(enable, row_words, region.height).box();
  if (!box || fits(linear, *box)) return 0;
  std::uint64_t count = 0;
  for (std::uint32_t y = box->top; y <= box->bottom; ++y) {
    if (fits(linear, Box{box->left, box->right, y, y})) continue;
    count += count_in_row(linear, y, enable.subspan(y * row_words, row_words));
  }
  return count;
}

}  // namespace csgsim::sim
