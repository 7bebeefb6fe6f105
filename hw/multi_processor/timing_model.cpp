#include "hw/multi_processor/timing_model.h"

#include "hw/base/quotient.h"

namespace csgsim::multi_processor {

namespace {

/// Bits to represent the numbers from 0 to `maximum`, at least one.
std::uint64_t bits_for(std::uint64_t maximum) {
  std::uint64_t bits = 1;
  while (maximum >> bits > 0) ++bits;
  return bits;
}

}  // namespace

std::uint64_t frame_words(const ModelSizes& sizes, std::uint32_t word_bits) {
  constexpr std::uint64_t header = 256;
  const std::uint64_t primitive = 4 * 15 + 2 * (sizes.depth + 1) + 2 + sizes.colour;
  const std::uint64_t node = 2 + sizes.operands;
  return quotient_up(header, word_bits) + sizes.primitives * quotient_up(primitive, word_bits) +
         sizes.nodes * quotient_up(node, word_bits);
}

std::uint64_t segment_words(const ModelSizes& sizes, std::uint64_t primitives, std::uint64_t halfspaces,
                            std::uint32_t word_bits) {
  return quotient_up(bits_for(sizes.primitives), word_bits) + primitives * quotient_up(request_bits(sizes), word_bits) +
         halfspaces * quotient_up(halfspace_bits(sizes), word_bits);
}

std::uint64_t halfspace_bits(const ModelSizes& sizes) {
  return 2 + 2 * std::uint64_t{sizes.slope} + sizes.constant + sizes.colour;
}

/// A request has the form of the record of a surviving primitive: an index and a number of half-spaces.
std::uint64_t request_bits(const ModelSizes& sizes) {
  return bits_for(sizes.primitives == 0 ? 0 : sizes.primitives - 1) + sizes.halfspaces;
}

std::uint64_t plane_bits(const ModelSizes& sizes) { return 1 + 2 * std::uint64_t{sizes.slope} + sizes.constant; }

}  // namespace csgsim::multi_processor
