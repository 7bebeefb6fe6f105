#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// What hands out the squares, as edges see it: the host, or a divider and the host before it.
class SenderTiming {
 public:
  /// `told`, unless null, is a blank timeline, which the renderers fill.
  SenderTiming(const isa::Program& program, const machines::Machine& machine, std::vector<RendererTiming>& renderers,
               Fifo<TimedPortWord>& clears, Agenda& agenda, machines::Timeline* told);

  /// The frame begins.
  void begin();

  /// What it does at an edge.
  void send(Time now);

  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const SquareClocks& host_clocks(Time end) {
    return has_divider_ ? host_.whole(end) : clocks_.whole(end);
  }
  [[nodiscard]] std::optional<SquareClocks> divider_clocks(Time end) {
    return has_divider_ ? std::optional(clocks_.whole(end)) : std::nullopt;
  }

 private:
  Time wait_for_host();
  Time take_model();
  [[nodiscard]] Time word_clocks() const { return has_divider_ ? 1 : machine_.link.word_clocks; }
  void begin_square(std::size_t square, Time now);
  void list_commands(const isa::Segment& segment);
  [[nodiscard]] std::uint64_t header_words() const;
  [[nodiscard]] std::uint64_t colour_words(const isa::Region& region) const;
  void ready(Time now);
  void send_header(Time now);
  void send_command(Time now);
  [[nodiscard]] std::size_t least_busy(Time now) const;

  const isa::Program& program_;
  const machines::Machine& machine_;
  const Figures& figures_;
  const bool has_divider_;
  const std::size_t part_;
  const std::uint32_t colour_bits_;
  std::vector<RendererTiming>& renderers_;
  Fifo<TimedPortWord>& clears_;
  Agenda& agenda_;
  machines::Timeline* told_;
  PartClocks host_;  ///< before a divider
  PartClocks clocks_;

  std::size_t square_ = 0;              ///< at hand
  std::vector<TimedCommand> commands_;  ///< of it; none, if it is cleared
  std::size_t command_ = 0;             ///< at hand
  std::uint64_t words_ = 0;             ///< of the command, or header, at hand
  std::uint64_t sent_ = 0;              ///< of these
  std::optional<std::size_t> target_;
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
