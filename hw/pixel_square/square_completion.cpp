#include "hw/pixel_square/square_completion.h"

#include "hw/systemc/array_view.h"

namespace csgsim::pixel_square {

SquareCompletion::SquareCompletion(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(SquareCompletion);
  SC_METHOD(complete);
  dont_initialize();
  sensitive << retired;
}

void SquareCompletion::complete() {
  const CommandAccount account = accounts.read();
  switch (account.kind) {
    case CommandAccount::Kind::start:
      segment_ = names_->segment_of(account.region);
      index_ = 0;
      break;
    case CommandAccount::Kind::instruction:
      retirement->after_instruction(
          {.segment = *segment_, .index = index_++, .clocks = account.clocks, .enabled_pixels = enabled_},
          systemc::ArrayView(enable->pixels()));
      break;
    case CommandAccount::Kind::end: retirement->after_segment(*segment_, systemc::ArrayView(enable->pixels())); return;
  }
  enabled_ = enable->count_enabled();
}

}  // namespace csgsim::pixel_square
