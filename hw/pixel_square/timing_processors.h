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

/// What a graphics processor puts on the ring.
struct TimedRingWord {
  std::optional<std::size_t> renderer;  ///< none: the frame buffer
  TimedLinkWord command;
  TimedPortWord header;
  bool ends = false;  ///< the last of its square
};

/// The graphics processors, as edges see them.
class ProcessorsTiming {
 public:
  /// `skips`: of the run, in program order. `told`, unless null, is a blank timeline, which the renderers fill.
  ProcessorsTiming(const isa::Program& program, const machines::Machine& machine,
                   std::vector<RendererTiming>& renderers, Agenda& agenda, std::span<const machines::Skip> skips,
                   machines::Timeline* told);

  /// The frame begins.
  void begin();

  /// What one of them does at an edge.
  void act(std::size_t number, Time now);

  /// The ring has taken the last word of its square: the renderer and the processor are free from the next edge on.
  void leave(std::size_t number, Time now);

  /// What waits for the ring.
  [[nodiscard]] Fifo<TimedRingWord>& words(std::size_t number) { return processors_[number].words; }

  [[nodiscard]] std::size_t count() const { return processors_.size(); }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }
  [[nodiscard]] const SquareClocks& clocks(std::size_t number, Time end) {
    return processors_[number].clocks.whole(end);
  }

 private:
  struct Processor {
    std::size_t part;
    Fifo<TimedRingWord> words;
    PartClocks clocks{};
    SquareActivity waits = SquareActivity::waiting_for_host;  ///< in clocks that have not been accounted for
    std::optional<std::size_t> square{};
    std::vector<TimedCommand> commands{};
    std::size_t command = 0;  ///< of these, at hand
    std::uint64_t sent = 0;   ///< words of it, or of the header
    bool all_sent = false;    ///< but some wait for the ring
    std::optional<std::size_t> renderer{};
  };
  /// Whether somebody keeps a renderer, and from which edge on nobody does.
  struct Keep {
    bool kept = false;
    Time free_from = 0;
  };

  bool take_square(Processor& processor);
  bool ask_for_renderer(Processor& processor, Time now);
  void send(Processor& processor, Time now);
  [[nodiscard]] TimedRingWord next_word(Processor& processor);
  void sleep(Processor& processor, SquareActivity why) { processor.waits = why; }

  const isa::Program& program_;
  const machines::Machine& machine_;
  std::vector<RendererTiming>& renderers_;
  Agenda& agenda_;
  std::span<const machines::Skip> skips_;
  machines::Timeline* told_;
  std::vector<Processor> processors_;
  std::vector<Keep> keeps_;  ///< of the renderers
  std::size_t next_ = 0;     ///< square that nobody has taken
  std::uint64_t skipped_ = 0;
};

}  // namespace csgsim::pixel_square
