#pragma once

#include <cstdint>
#include <string_view>

#include "host/effects/flat_shading.h"
#include "host/facet/scene.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// How classifications are worked out at the pixels.
enum class Strategy : std::uint8_t {
  stack,  ///< the active tree once for a primitive, one bit a pending result
};

/// The strategy's name on the command line and in the stats.
std::string_view name_of(Strategy strategy);

struct Options {
  Strategy strategy = Strategy::stack;
  std::uint32_t memory_bits = 72;  ///< a pixel
  effects::FlatShading shading;
};

/// Compiles a scene, as a view sees it, into a Program with one segment, the whole picture (Pixel-planes). Throws
/// InputError where the model does not fit the machine.
isa::Program compile(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
                     const Options& options);

}  // namespace csgsim::emit
