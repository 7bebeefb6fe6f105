#include "hw/array/column_bits.h"

namespace csgsim::array {

namespace {

/// Transposes the 64 x 64 bits in each column of 64 rows of words: bit i of row j becomes bit j of row i. Only the
/// first `bits` rows of the result are valid.
void transpose(Words& rows, std::size_t stride, std::size_t columns, std::size_t bits) {
  std::uint64_t mask = low_bits(word_bits / 2);
  std::size_t height = word_bits;  // rows that still affect the result
  for (std::size_t distance = word_bits / 2; distance > 0; distance /= 2) {
    for (std::size_t row = 0; row < height; row = (row + distance + 1) & ~distance) {
      std::uint64_t* const upper = &rows[row * stride];
      std::uint64_t* const lower = &rows[(row + distance) * stride];
      for (std::size_t i = 0; i < columns; ++i) {
        const std::uint64_t swapped = (upper[i] >> distance ^ lower[i]) & mask;
        lower[i] ^= swapped;
        upper[i] ^= swapped << distance;
      }
    }
    mask ^= mask << distance / 2;
    if (bits <= distance) height = distance;
  }
}

}  // namespace

ColumnBits::ColumnBits(PlaneShape shape, std::span<const Place> places)
    : width_(shape.width),
      row_words_(shape.row_words()),
      stride_(round_up(row_words_ + kernels::block_words, kernels::block_words)),
      places_(places.begin(), places.end()) {}

std::span<const kernels::StreamTable> ColumnBits::compute_tables(std::span<const Stream> streams) {
  if (words_.size() < streams.size()) words_.resize(streams.size(), Words(word_bits * stride_));
  tables_.clear();
  for (std::size_t i = 0; i < streams.size(); ++i) tables_.push_back(build_table(streams[i], words_[i]));
  return tables_;
}

/// Beyond the row's width the columns repeat, starting with the first.
kernels::StreamTable ColumnBits::build_table(const Stream& stream, Words& words) const {
  if (stream.xy != 0 && places_.empty()) return {.bits = stream.bits, .crossed = &stream};
  const std::uint64_t second = 2 * word_bits * word_bits * stream.xx;  // second difference from word to word
  for (std::size_t bit = 0; bit < word_bits; ++bit) {
    std::uint64_t* const row = &words[bit * stride_];
    std::uint64_t value = value_at(stream, bit, 0);
    std::uint64_t step = value_at(stream, bit + word_bits, 0) - value;
    for (std::size_t word = 0; word < row_words_; ++word, step += second) {
      row[word] = value;
      value += step;
    }
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    words[i % word_bits * stride_ + i / word_bits] = value_at(stream, places_[i].x, places_[i].y);
  }
  transpose(words, stride_, row_words_, stream.bits);
  for (std::size_t bit = 0; bit < stream.bits; ++bit) {
    std::uint64_t* const row = &words[bit * stride_];
    for (std::size_t word = row_words_; word < stride_; ++word) row[word] = row[word - row_words_];
  }
  return {.columns = words.data(),
          .stride = stride_,
          .b = places_.empty() ? stream.b : 0,
          .yy = places_.empty() ? stream.yy : 0,
          .bits = stream.bits};
}

}  // namespace csgsim::array
