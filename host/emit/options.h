#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "host/csg/pruning.h"
#include "host/scene/scene.h"
#include "hw/base/work.h"
#include "hw/isa/colour_format.h"

namespace csgsim::emit {

/// How classifications are worked out at the pixels. The pictures are the same, bit for bit.
enum class Strategy : std::uint8_t {
  stack,      ///< the active tree once for a primitive, one bit a pending result
  list,       ///< ordered Boolean list: the label of the leaf that a pixel waits for
  bits,       ///< thesis 6.4: the first levels by a stack, subtrees below by repeated traversal
  products,   ///< thesis 6.3: sum of products, a primitive rendered once for each
  parallel,   ///< thesis 4.4.2: one bit a leaf, all nodes of a level at once
  stored,     ///< thesis 6.1: as stack, but depths of primitives that are compared are kept, rendered once each
  polygons,   ///< thesis 7.2.1 and 8.2: what is compared with nothing is drawn face by face, the rest as by stack
  automatic,  ///< whichever of the others, but polygons, takes the fewest clocks and fits
};

inline constexpr std::array strategies{Strategy::stack,    Strategy::list,   Strategy::bits,     Strategy::products,
                                       Strategy::parallel, Strategy::stored, Strategy::polygons, Strategy::automatic};

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
