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

/// Edge-level model of the sender of squares: the host, or the unit that sends the squares stored by dividers.
class SenderTiming {
 public:
  /// Models the host if there are no dividers. `skips`: skips of the run, in program order. `timeline`: null, or a
  /// blank timeline that the renderers fill.
  SenderTiming(const isa::Program& program, const machines::Machine& machine, std::vector<DividerTiming>& dividers,
               std::vector<RendererTiming>& renderers, Fifo<TimedPortWord>& clears, Agenda& agenda,
               std::span<const machines::Skip> skips, machines::Timeline* timeline);

  /// Begins the frame.
  void begin();

  /// Lets the sender act at an edge.
  void send(Time now);

  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const SquareClocks& clocks(Time end) { return clocks_.complete(end); }

 private:
  [[nodiscard]] bool is_host() const { return dividers_.empty(); }
  [[nodiscard]] StoreTiming& store() { return dividers_[sources_[square_]].store(); }
  void begin_host_square();
  bool try_begin_square(Time now);
  void sleep(SquareActivity activity, bool retry_next_edge, Time now);
  void send_header(Time now);
  void send_word(Time now);
  TimedStored take_word(Time now);
  void schedule_next(Time now);
  void end_square(Time now);
  [[nodiscard]] std::size_t least_busy(Time now) const;

  const isa::Program& program_;
  const machines::Machine& machine_;
  const std::size_t part_;
  std::vector<DividerTiming>& dividers_;
  const std::vector<std::size_t> sources_;  ///< divider of each square
  std::vector<RendererTiming>& renderers_;
  Fifo<TimedPortWord>& clears_;
  Agenda& agenda_;
  std::span<const machines::Skip> skips_;
  machines::Timeline* timeline_;
  PartClocks clocks_;
  SquareActivity activity_;  ///< activity in the clocks not counted yet

  std::size_t square_ = 0;  ///< index of the current square
  bool begun_ = false;
  bool is_clear_ = false;
  std::uint64_t sent_ = 0;              ///< words sent of the header, or of the host's current command
  std::vector<TimedCommand> commands_;  ///< commands of the square that the host sends
  std::size_t command_ = 0;             ///< index of the current command
  std::optional<std::size_t> target_;
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
