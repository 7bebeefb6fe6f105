#pragma once

#include "host/csg/counted.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/division/display_model.h"

namespace csgsim::emit {

/// How a Program has to be compiled to have the instructions that the divider emits from the display model with these
/// options: the divider's strategy and prunings, the colouring, colours and shading asked for.
Options divider_options(Options options);

/// What the host sends to the divider: the transformed model, and where the fields are in a pixel's memory. All memory
/// bits that other fields leave are for the stack. Throws InputError if the other fields do not fit, if the colouring
/// is left to be chosen, or, naming the primitive, where coefficients of a face do not fit and the face may matter
/// somewhere in the primitive's rectangle of pixels.
division::DisplayModel make_display_model(const model::Tree& tree, const facet::Geometry& geometry,
                                          const view::View& view, const Options& options, std::uint32_t memory_bits,
                                          const csg::Counted& counted = {});

}  // namespace csgsim::emit
