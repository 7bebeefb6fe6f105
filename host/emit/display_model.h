// The display model, which the host sends to a machine that divides the model itself.
// Used by divided.cpp, division counts and tests.
#pragma once

#include "host/csg/counted.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/division/display_model.h"

namespace csgsim::emit {

/// Compile options for a Program with the instructions that the divider generates from the display model: the divider's
/// strategy and prunings, with the colouring, colours and shading of `options`.
Options divider_options(Options options);

/// Makes the data that the host sends to the divider: the transformed model, and the positions of the fields in pixel
/// memory. The
/// stack gets all memory bits that other fields leave. Throws InputError if the other fields do not fit, if the
/// colouring is automatic, or, naming the primitive, if coefficients of a face do not fit and the face may matter
/// somewhere in the primitive's rectangle of pixels.
division::DisplayModel make_display_model(const model::Tree& tree, const facet::Geometry& geometry,
                                          const view::View& view, const Options& options, std::uint32_t memory_bits,
                                          const csg::Counted& counted = {});

}  // namespace csgsim::emit
