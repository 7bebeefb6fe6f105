#include "hw/pixel_square/square_completion.h"

#include "hw/systemc/array_view.h"

namespace csgsim::pixel_square {

SquareCompletion::SquareCompletion(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(SquareCompletion);
  SC_METHOD(complete);
  dont_initialize();
  sensitive << retired << accounts.data_written();
}

/// The account of a global-OR test arrives after the test has reached the pixels; the account of any other command
/// arrives before.
void SquareCompletion::complete() {
  CommandAccount account;
  if (reported_ == retired.read() || !accounts.nb_read(account)) return;
  ++reported_;
  report(account);
  if (account.kind != CommandAccount::Kind::end) enabled_ = enable->count_enabled();
}

void SquareCompletion::report(const CommandAccount& account) {
  switch (account.kind) {
    case CommandAccount::Kind::start:
      segment_ = names_->segment_of(account.region);
      index_ = 0;
      return;
    case CommandAccount::Kind::instruction:
      retirement->after_instruction({.segment = *segment_,
                                     .index = index_,
                                     .clocks = account.clocks,
                                     .enabled_pixels = enabled_,
                                     .skipped = account.skipped},
                                    systemc::ArrayView(enable->pixels()));
      index_ += static_cast<std::uint32_t>(1 + account.skipped);
      skipped_ += account.skipped;
      return;
    case CommandAccount::Kind::end: retirement->after_segment(*segment_, systemc::ArrayView(enable->pixels())); return;
  }
}

}  // namespace csgsim::pixel_square
