#include "hw/pixel_planes/linear_expression_evaluator.h"

#include <utility>

namespace csgsim::pixel_planes {

/// Without a level the leaves are wires, which follow the roots within the clock.
LinearExpressionEvaluator::LinearExpressionEvaluator(sc_core::sc_module_name name, array::PlaneShape shape,
                                                     unsigned register_levels,
                                                     std::optional<array::SteppedEvaluator> adders)
    : sc_core::sc_module(name), trees_(shape, register_levels), adders_(std::move(adders)) {
  if (adders_) pixels_.fill(array::Words(adders_->leaf_words()));
  SC_HAS_PROCESS(LinearExpressionEvaluator);
  SC_METHOD(step);
  dont_initialize();
  if (trees_.latency() == 0) {
    sensitive << root;
  } else {
    sensitive << clock.pos();
  }
}

/// Sleeps while no bit is on its way.
void LinearExpressionEvaluator::step() {
  if (trees_.latency() > 0 && !clock.posedge()) return;
  const array::RootBits& bits = root.read().bits;
  if (adders_) {
    step_adders(bits);
  } else if (TreeWord word; trees_.clock(bits, word.bit)) {
    leaves.write(word);
  }
  const bool is_active = adders_ ? adders_->any_active() : trees_.any_active();
  if (!bits.token.active() && !is_active) next_trigger(root.value_changed_event());
}

void LinearExpressionEvaluator::step_adders(const array::RootBits& bits) {
  array::Words& pixels = pixels_.at(1 - written_);
  const array::Token token = adders_->clock(bits, pixels);
  if (!token.active()) return;
  written_ = 1 - written_;
  leaves.write({.bit = {.token = token}, .pixels = &pixels});
}

}  // namespace csgsim::pixel_planes
