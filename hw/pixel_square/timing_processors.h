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
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// A word that a graphics processor puts on the ring.
struct TimedRingWord {
  std::optional<std::size_t> renderer;  ///< destination; empty for the frame buffer
  TimedLinkWord command;
  TimedPortWord header;
  bool ends = false;  ///< whether this is the last word of its square
};

/// Edge-level model of the graphics processors.
class ProcessorsTiming {
 public:
  /// `skips`: skips of the run, in program order. `timeline`: null, or a blank timeline that the renderers fill.
  ProcessorsTiming(const isa::Program& program, const machines::Machine& machine,
                   std::vector<RendererTiming>& renderers, Agenda& agenda, std::span<const machines::Skip> skips,
                   machines::Timeline* timeline);

  /// Begins the frame.
  void begin();

  /// Lets one processor act at an edge.
  void act(std::size_t processor_index, Time now);

  /// Records that the ring has taken the last word of the processor's square: renderer and processor are free from the
  /// next edge on.
  void leave(std::size_t processor_index, Time now);

  /// Words of a processor that wait for the ring.
  [[nodiscard]] Fifo<TimedRingWord>& words(std::size_t processor_index) { return processors_[processor_index].words; }

  [[nodiscard]] std::size_t count() const { return processors_.size(); }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const SquareClocks& clocks(std::size_t processor_index, Time end) {
    return processors_[processor_index].clocks.complete(end);
  }

 private:
  struct Processor {
    std::size_t part;
    Fifo<TimedRingWord> words;
    PartClocks clocks{};
    SquareActivity activity = SquareActivity::waiting_for_host;  ///< activity in the clocks not counted yet
    std::optional<std::size_t> square{};
    std::vector<TimedCommand> commands{};
    std::size_t command = 0;  ///< index of the current command
    std::uint64_t sent = 0;   ///< number of words sent of that command, or of the header
    bool all_sent = false;    ///< whether all words are sent but some still wait for the ring
    std::optional<std::size_t> renderer{};
  };
  /// Whether a processor keeps a renderer; otherwise the edge from which the renderer is available again.
  struct Reservation {
    bool reserved = false;
    Time free_from = 0;
  };

  bool try_take_square(Processor& processor);
  bool try_request_renderer(Processor& processor, Time now);
  void send(Processor& processor, Time now);
  [[nodiscard]] TimedRingWord next_word(Processor& processor);
  void sleep(Processor& processor, SquareActivity activity) { processor.activity = activity; }

  const isa::Program& program_;
  const machines::Machine& machine_;
  std::vector<RendererTiming>& renderers_;
  Agenda& agenda_;
  std::span<const machines::Skip> skips_;
  machines::Timeline* timeline_;
  std::vector<Processor> processors_;
  std::vector<Reservation> reservations_;  ///< one per renderer
  std::size_t next_ = 0;                   ///< first square that no processor has taken
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
