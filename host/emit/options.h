// Compile options: strategy, colouring, pruning, scene and effects.
// Used by host/effects, host/setup, sim/session and sim/studies.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "host/csg/prices.h"
#include "host/csg/pruning.h"
#include "host/scene/scene.h"
#include "hw/base/work.h"
#include "hw/isa/colour_format.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// The ways to compute classifications at the pixels, in the order in which messages list them. Each is a file of this
/// folder with a row (strategy.h). All give the same picture, bit for bit.
#define CSGSIM_STRATEGIES(ROW) ROW(stack) ROW(list) ROW(bits) ROW(products) ROW(parallel) ROW(stored) ROW(polygons)
#define CSGSIM_ENUMERATOR(name) name,
#define CSGSIM_OWN_ENUMERATOR(name) Strategy::name,

enum class Strategy : std::uint8_t {
  CSGSIM_STRATEGIES(CSGSIM_ENUMERATOR) automatic  ///< the strategy with the fewest clocks among those that fit and may
                                                  ///< be chosen
};

inline constexpr std::array strategies{CSGSIM_STRATEGIES(CSGSIM_OWN_ENUMERATOR) Strategy::automatic};

#undef CSGSIM_OWN_ENUMERATOR
#undef CSGSIM_ENUMERATOR

/// The strategies that studies vary by default. `polygons` is not among them: it takes the bits of a stack and more
/// clocks (docs/accuracy.md).
std::vector<Strategy> default_strategies();

/// The strategy's name on the command line and in the stats.
std::string_view name_of(Strategy strategy);

/// How the colour of a surface reaches the pixels that show it.
enum class Colouring : std::uint8_t {
  rebroadcast,  ///< the facets are broadcast again after the merge, to find the pixels of each
  field,        ///< a second colour field is written along with Z1, and copied by the merge
  automatic,    ///< the colouring with the fewest clocks that fits
};

inline constexpr std::array colourings{Colouring::rebroadcast, Colouring::field, Colouring::automatic};

std::string_view name_of(Colouring colouring);

/// Minimum number of bits for `Strategy::bits`, as the thesis counts them (fig. 6.3): one each for the front and back
/// of the compared primitive, and one for the product. From four bits on, one of them sums the products.
inline constexpr unsigned min_stack_bits = 3;

/// Maximum number of products that a segment is compiled for.
inline constexpr std::uint64_t max_products = 16'384;

struct EffectRow;
struct Options;

/// The options with `prices` computed for the machine by `prices_on`, if that is given.
Options with_prices(Options options, const machines::Machine& machine);

/// A list of effects with flat shading only.
std::span<const EffectRow* const> only_flat_shading();

struct Options {
  Strategy strategy = Strategy::stack;
  unsigned stack_bits = min_stack_bits;  ///< for Strategy::bits: m of thesis 6.4, at least min_stack_bits
  Colouring colouring = Colouring::rebroadcast;
  unsigned colour_bits = isa::max_colour_bits;
  csg::Pruning pruning;
  csg::Prices prices;
  csg::Prices (*prices_on)(const machines::Machine& machine) = nullptr;  ///< if given, replaces `prices`
  scene::Scene scene;
  std::span<const EffectRow* const> effects = only_flat_shading();  ///< all known effects, in the order of their work
  Work work{};  ///< limit on the work of compiling, for each tried strategy and colouring separately
};

}  // namespace csgsim::emit
