#include "sim/checkpoint/packed.h"

#include <algorithm>

namespace csgsim::checkpoint {

namespace {

enum class Words : std::uint8_t { zeros, ones, literal };
constexpr unsigned kinds = 4;  ///< number of kinds that the encoding of a run can distinguish

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

Words kind_of(std::uint64_t word) { return word == 0 ? Words::zeros : word == all_ones ? Words::ones : Words::literal; }

/// Validates the length of a run: at least 1 and at most the number of missing items.
std::size_t run_length(std::uint64_t count, std::size_t missing) {
  if (count == 0 || count > missing) throw isa::MalformedBytes("holds a run of a wrong length");
  return static_cast<std::size_t>(count);
}

}  // namespace

void put_fixed(isa::ByteWriter& out, std::uint64_t value, unsigned byte_count) {
  for (unsigned i = 0; i < byte_count; ++i) out.byte(static_cast<std::uint8_t>(value >> 8U * i));
}

std::uint64_t read_fixed(isa::ByteReader& in, unsigned byte_count) {
  std::uint64_t value = 0;
  for (unsigned i = 0; i < byte_count; ++i) value |= std::uint64_t{in.byte()} << 8U * i;
  return value;
}

void put_plane(isa::ByteWriter& out, std::span<const std::uint64_t> plane, std::size_t word_count) {
  if (plane.empty()) {
    if (word_count > 0) out.varint(word_count * kinds);
    return;
  }
  for (std::size_t begin = 0; begin < word_count;) {
    const Words kind = kind_of(plane[begin]);
    std::size_t end = begin + 1;
    while (end < word_count && kind_of(plane[end]) == kind) ++end;
    out.varint((end - begin) * kinds + static_cast<unsigned>(kind));
    for (; begin < end; ++begin)
      if (kind == Words::literal) put_fixed(out, plane[begin], 8);
  }
}

std::vector<std::uint64_t> read_plane(isa::ByteReader& in, std::size_t word_count) {
  std::vector<std::uint64_t> plane;
  bool any = false;
  while (plane.size() < word_count) {
    const std::uint64_t number = in.varint();
    const std::size_t count = run_length(number / kinds, word_count - plane.size());
    switch (number % kinds) {
      case static_cast<unsigned>(Words::zeros): plane.resize(plane.size() + count); break;
      case static_cast<unsigned>(Words::ones):
        plane.resize(plane.size() + count, all_ones);
        any = true;
        break;
      case static_cast<unsigned>(Words::literal):
        for (std::size_t i = 0; i < count; ++i) plane.push_back(read_fixed(in, 8));
        any = true;
        break;
      default: throw isa::MalformedBytes("holds a run of an undefined kind");
    }
  }
  if (!any || std::all_of(plane.begin(), plane.end(), [](std::uint64_t word) { return word == 0; })) plane.clear();
  return plane;
}

void put_pixels(isa::ByteWriter& out, std::span<const std::uint32_t> pixels) {
  for (std::size_t begin = 0; begin < pixels.size();) {
    std::size_t end = begin + 1;
    while (end < pixels.size() && pixels[end] == pixels[begin]) ++end;
    out.varint(end - begin);
    out.varint(pixels[begin]);
    begin = end;
  }
}

std::vector<std::uint32_t> read_pixels(isa::ByteReader& in, std::size_t count) {
  std::vector<std::uint32_t> pixels;
  while (pixels.size() < count) {
    const std::size_t length = run_length(in.varint(), count - pixels.size());
    pixels.resize(pixels.size() + length, in.varint_at_most<std::uint32_t>(~std::uint32_t{0}));
  }
  return pixels;
}

void put_bits(isa::ByteWriter& out, const std::vector<bool>& bits) {
  out.varint(bits.size());
  for (std::size_t begin = 0; begin < bits.size(); begin += 8) {
    unsigned byte = 0;
    for (std::size_t i = begin; i < std::min(begin + 8, bits.size()); ++i) byte |= unsigned{bits[i]} << (i - begin);
    out.byte(static_cast<std::uint8_t>(byte));
  }
}

std::vector<bool> read_bits(isa::ByteReader& in, std::uint64_t max_count) {
  const auto count = in.varint_at_most<std::size_t>(max_count);
  std::vector<bool> bits;
  for (std::size_t begin = 0; begin < count; begin += 8) {
    const unsigned byte = in.byte();
    for (std::size_t i = begin; i < std::min(begin + 8, count); ++i) bits.push_back((byte >> (i - begin) & 1U) != 0);
  }
  return bits;
}

}  // namespace csgsim::checkpoint
