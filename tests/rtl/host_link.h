#pragma once

#include <cstddef>
#include <cstdint>

#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"
#include "tests/rtl/rtl_machine.h"

namespace csgsim::rtl {

/// The host's end of the link, after docs/machines/pixel-planes.md.
class HostLink {
 public:
  explicit HostLink(const machines::Link& link) : link_(link) {}

  /// Puts a frame into the host's memory and forgets the one before.
  void load(link::FrameWords frame);

  /// What the host puts on the wires for the next edge, at which the machine's were `outputs`.
  void drive(const Outputs& outputs, Inputs& inputs);

 private:
  [[nodiscard]] bool sending() const { return latent_ == 0 && next_ < frame_.words.size(); }

  machines::Link link_;
  link::FrameWords frame_;
  std::size_t next_ = 0;       ///< the word on the link, or that will be
  std::uint32_t latent_ = 0;   ///< clocks until it is on the link
  std::uint32_t on_link_ = 0;  ///< clocks that it still has to be there
};

}  // namespace csgsim::rtl
