#include "tests/rtl/host_link.h"

#include <utility>

namespace csgsim::rtl {

void HostLink::load(link::FrameWords frame) {
  frame_ = std::move(frame);
  next_ = frame_.words.size();
  latent_ = 0;
}

void HostLink::drive(const Outputs& outputs, Inputs& inputs) {
  inputs.word_valid = false;
  if (outputs.request) {
    // A request sent at the previous edge has arrived; the word on the link is lost.
    next_ = outputs.request_from < frame_.begins.size() ? frame_.begins[outputs.request_from] : frame_.words.size();
    latent_ = link_.latency;
    on_link_ = link_.word_clocks;
    return;
  }
  if (latent_ > 0) {
    --latent_;
    return;
  }
  if (!sending()) return;
  if (on_link_ > 1) {
    --on_link_;
    return;
  }
  inputs.word_valid = true;
  inputs.word = frame_.words[next_];
  if (outputs.word_ready) {
    ++next_;
    on_link_ = link_.word_clocks;
  }
}

}  // namespace csgsim::rtl
