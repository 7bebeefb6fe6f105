// Automatic choice of depth and fraction bits.
// Used by sim/app and sim/python.
#pragma once

#include "host/model/tree.h"
#include "hw/machines/machine.h"
#include "sim/session/run/render.h"

namespace csgsim::studies {

/// Sets the request's z bits and fraction bits to the cheapest pair whose picture has at most request.max_wrong_pixels
/// wrong pixels, and prints them. Throws InputError if there is no such pair.
void choose_bits(session::RenderRequest& request, const machines::Machine& machine, const model::Tree& tree);

}  // namespace csgsim::studies
