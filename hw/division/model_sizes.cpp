#include "hw/division/model_sizes.h"

namespace csgsim::division {

namespace {

/// Position of a number in the stream; the first bit is the lowest of the first byte.
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
constexpr Place at_plane{164, 5};
constexpr unsigned header_bits = 169;

std::uint32_t number_at(Place place, std::span<const std::uint8_t> bytes) {
  std::uint32_t number = 0;
  for (unsigned i = 0; i < place.bits; ++i) {
    const unsigned bit = place.first + i;
    number |= (std::uint32_t{bytes[bit / 8]} >> bit % 8 & 1U) << i;
  }
  return number;
}

}  // namespace

ModelSizes read_model_sizes(std::span<const std::uint8_t> display_model) {
  if (8 * display_model.size() < header_bits) return {};
  const auto number = [&](Place place) { return number_at(place, display_model); };
  return {number(at_planes), number(at_primitives), number(at_nodes),      number(at_depth),    number(at_colour),
          number(at_slope),  number(at_constant),   number(at_halfspaces), number(at_operands), number(at_plane)};
}

}  // namespace csgsim::division
