#pragma once

#include "host/model/tree.h"
#include "hw/machines/machine.h"
#include "sim/session/run/render.h"

namespace csgsim::studies {

/// Puts the cheapest z bits and fraction bits whose picture has at most request.max_wrong_pixels wrong pixels into the
/// request, and prints which. Throws InputError if there are none.
void choose_bits(session::RenderRequest& request, const machines::Machine& machine, const model::Tree& tree);

}  // namespace csgsim::studies
