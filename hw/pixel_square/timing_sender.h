#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "hw/pixel_square/timing_divider.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// What hands out the squares, as edges see it: the host, or what sends those that dividers have stored.
class SenderTiming {
 public:
  /// Without dividers it is the host. `skips`: of the run, in program order. `told`, unless null, is a blank timeline,
  /// which the renderers fill.
  SenderTiming(const isa::Program& program, const machines::Machine& machine, std::vector<DividerTiming>& dividers,
               std::vector<RendererTiming>& renderers, Fifo<TimedPortWord>& clears, Agenda& agenda,
               std::span<const machines::Skip> skips, machines::Timeline* told);

  /// The frame begins.
  void begin();

  /// What it does at an edge.
  void send(Time now);

  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.whole(end); }

 private:
  [[nodiscard]] bool is_host() const { return dividers_.empty(); }
  [[nodiscard]] StoreTiming& store() { return dividers_[sources_[square_]].store(); }
  void begin_host_square();
  bool begin_square(Time now);
  void sleep(SquareActivity why, bool look_again, Time now);
  void send_header(Time now);
  void send_word(Time now);
  TimedStored take_word(Time now);
  void go_on(Time now);
  void end_square(Time now);
  [[nodiscard]] std::size_t least_busy(Time now) const;

  const isa::Program& program_;
  const machines::Machine& machine_;
  const std::size_t part_;
  std::vector<DividerTiming>& dividers_;
  const std::vector<std::size_t> sources_;  ///< of each square its divider
  std::vector<RendererTiming>& renderers_;
  Fifo<TimedPortWord>& clears_;
  Agenda& agenda_;
  std::span<const machines::Skip> skips_;
  machines::Timeline* told_;
  PartClocks clocks_;
  SquareActivity waits_;  ///< what it does in clocks that have not been accounted for

  std::size_t square_ = 0;  ///< at hand
  bool begun_ = false;
  bool is_clear_ = false;
  std::uint64_t sent_ = 0;              ///< words of the header, or of the host's command, at hand
  std::vector<TimedCommand> commands_;  ///< of a host's square
  std::size_t command_ = 0;             ///< at hand
  std::optional<std::size_t> target_;
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
