#include "hw/multi_processor/timing_model.h"

#include "hw/base/quotient.h"

namespace csgsim::multi_processor {

namespace {

/// A number of the stream, the first bit in the lowest of the first byte.
struct Place {
  unsigned first = 0;
  unsigned bits = 0;
};

constexpr Place at_planes{0, 32};
constexpr Place at_primitives{32, 32};
constexpr Place at_nodes{64, 32};
constexpr Place at_depth{126, 5};
constexpr Place at_colour{136, 5};
constexpr Place at_slope{141, 6};
constexpr Place at_constant{147, 6};
constexpr Place at_halfspaces{153, 6};
constexpr Place at_operands{159, 5};
constexpr unsigned header_bits = 164;

std::uint32_t number_at(Place place, std::span<const std::uint8_t> bytes) {
  std::uint32_t number = 0;
  for (unsigned i = 0; i < place.bits; ++i) {
    const unsigned bit = place.first + i;
    number |= (std::uint32_t{bytes[bit / 8]} >> bit % 8 & 1U) << i;
  }
  return number;
}

/// Bits that tell numbers from 0 to the most, one at least.
std::uint32_t bits_to_tell(std::uint64_t most) {
  std::uint32_t bits = 1;
  while (most >> bits > 0) ++bits;
  return bits;
}

}  // namespace

ModelSizes sizes_of(std::span<const std::uint8_t> display_model) {
  if (8 * display_model.size() < header_bits) return {};
  const auto number = [&](Place place) { return number_at(place, display_model); };
  return {number(at_planes), number(at_primitives), number(at_nodes),      number(at_depth),   number(at_colour),
          number(at_slope),  number(at_constant),   number(at_halfspaces), number(at_operands)};
}

std::uint64_t frame_words(const ModelSizes& sizes, std::uint32_t word_bits) {
  constexpr std::uint64_t header = 256;
  const std::uint64_t primitive = 4 * 15 + 2 * (sizes.depth + 1) + 2 + sizes.colour;
  const std::uint64_t node = 2 + sizes.operands;
  return quotient_up(header, word_bits) + sizes.primitives * quotient_up(primitive, word_bits) +
         sizes.nodes * quotient_up(node, word_bits);
}

std::uint64_t segment_words(const ModelSizes& sizes, std::uint64_t primitives, std::uint64_t halfspaces,
                            std::uint32_t word_bits) {
  const std::uint64_t last = sizes.primitives == 0 ? 0 : sizes.primitives - 1;
  const std::uint64_t left = bits_to_tell(last) + sizes.halfspaces;
  const std::uint64_t halfspace = 2 + 2 * std::uint64_t{sizes.slope} + sizes.constant + sizes.colour;
  return quotient_up(bits_to_tell(sizes.primitives), word_bits) + primitives * quotient_up(left, word_bits) +
         halfspaces * quotient_up(halfspace, word_bits);
}

}  // namespace csgsim::multi_processor
