#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "host/csg/pruning.h"
#include "host/scene/scene.h"
#include "hw/base/work.h"
#include "hw/isa/colour_format.h"

namespace csgsim::emit {

/// How classifications are worked out at the pixels, in the order of messages; each is a file of this folder with a row
/// (strategy.h). The pictures are the same, bit for bit.
#define CSGSIM_STRATEGIES(ROW) ROW(stack) ROW(list) ROW(bits) ROW(products) ROW(parallel) ROW(stored) ROW(polygons)
#define CSGSIM_ENUMERATOR(name) name,
#define CSGSIM_OWN_ENUMERATOR(name) Strategy::name,

enum class Strategy : std::uint8_t {
  CSGSIM_STRATEGIES(CSGSIM_ENUMERATOR) automatic  ///< whichever that may be chosen takes the fewest clocks and fits
};

inline constexpr std::array strategies{CSGSIM_STRATEGIES(CSGSIM_OWN_ENUMERATOR) Strategy::automatic};

#undef CSGSIM_OWN_ENUMERATOR
#undef CSGSIM_ENUMERATOR

/// Strategies that studies vary by default: not polygons, which takes the bits of a stack and more clocks
/// (docs/accuracy.md).
std::vector<Strategy> usual_strategies();

/// The strategy's name on the command line and in the stats.
std::string_view name_of(Strategy strategy);

/// How the colour of a surface gets to the pixels that show it.
enum class Colouring : std::uint8_t {
  rebroadcast,  ///< the facets are broadcast again after the merge, to find where each is seen
  field,        ///< a second colour field is written beside Z1, and copied by the merge
  automatic,    ///< whichever takes the fewest clocks and fits
};

inline constexpr std::array colourings{Colouring::rebroadcast, Colouring::field, Colouring::automatic};

std::string_view name_of(Colouring colouring);

/// The fewest bits that `Strategy::bits` works with, as the thesis counts them (fig. 6.3): one each for the front and
/// back of the primitive compared, one for the product. From the next on, one sums the products.
inline constexpr unsigned fewest_stack_bits = 3;

/// Most products that a segment of a Program is compiled for.
inline constexpr std::uint64_t most_products = 16'384;

struct EffectRow;

/// Flat shading and no other effect.
std::span<const EffectRow* const> flat_alone();

struct Options {
  Strategy strategy = Strategy::stack;
  unsigned stack_bits = fewest_stack_bits;  ///< for Strategy::bits: m of thesis 6.4, fewest_stack_bits at least
  Colouring colouring = Colouring::rebroadcast;
  unsigned colour_bits = isa::most_colour_bits;
  csg::Pruning pruning;
  scene::Scene scene;
  std::span<const EffectRow* const> effects = flat_alone();  ///< all that there are, in the order of their work
  Work work{};  ///< that compiling is charged to; each strategy and colouring that is tried counts alone
};

}  // namespace csgsim::emit
