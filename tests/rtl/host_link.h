#pragma once

#include <cstddef>
#include <cstdint>

#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "tests/rtl/rtl_machine.h"

namespace csgsim::rtl {

/// The host's end of the link, following docs/machines/pixel-planes.md.
class HostLink {
 public:
  explicit HostLink(const machines::Link& link) : link_(link) {}

  /// Loads a frame into the host's memory in place of the previous one.
  void load(link::FrameWords frame);

  /// Sets the host's wires for the next edge, given the machine's `outputs` of the last one.
  void drive(const Outputs& outputs, Inputs& inputs);

 private:
  [[nodiscard]] bool sending() const { return latent_ == 0 && next_ < frame_.words.size(); }

  machines::Link link_;
  link::FrameWords frame_;
  std::size_t next_ = 0;       ///< index of the current or next word on the link
  std::uint32_t latent_ = 0;   ///< clocks until that word is on the link
  std::uint32_t on_link_ = 0;  ///< clocks for which it remains there
};

}  // namespace csgsim::rtl
