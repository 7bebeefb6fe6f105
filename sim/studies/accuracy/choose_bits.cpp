#include "sim/studies/accuracy/choose_bits.h"

#include <fmt/format.h>

#include "hw/base/error.h"
#include "hw/base/prints.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/studies/accuracy/measure.h"

namespace csgsim::studies {

void choose_bits(session::RenderRequest& request, const machines::Machine& machine, const model::Tree& tree) {
  const facet::Faceting faceting = session::faceting_of(request.model, machine, tree);
  const view::Camera camera = session::camera_of(request.model, machine, tree, facet::make_geometry(tree, faceting));
  const emit::Options options = session::emit_options_of(request.model);
  session::refuse_transparent_parts(options, tree, camera);
  Meter meter(tree, {camera}, machine, options);
  const auto chosen = cheapest_settings(meter, bit_width_pairs(session::sampling_of(request.model, machine), faceting),
                                        *request.max_wrong_pixels);
  if (!chosen) {
    throw InputError(
        fmt::format("every choice of --z-bits and --fraction-bits that fits the machine has more than {} wrong pixels; "
                    "allow more wrong pixels, or use csgsim accuracy to find their causes",
                    *request.max_wrong_pixels));
  }
  request.model.z_bits = chosen->sampling.z_bits;
  request.model.fraction_bits = chosen->sampling.fraction_bits;
  print_text(fmt::format("{:<18}--z-bits {} --fraction-bits {}: the cheapest with at most {} wrong pixels\n", "chosen",
                         request.model.z_bits, request.model.fraction_bits, *request.max_wrong_pixels));
}

}  // namespace csgsim::studies
