#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/collector.h"
#include "hw/multi_processor/division.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// A processor of the array, which holds every so-many-th pixel of every so-many-th row of the picture. A segment's
/// data comes over the bus, then the node prunes the half-spaces for the subsegment of its own number. When all have
/// done so, each sends its list in turn; then all render subsegment by subsegment, each its own pixels, and wait for
/// the slowest after each. What a node does to its pixels no other part can see until it comes to the barrier: it does
/// all of a subsegment at once and then sleeps for the clocks that this takes.
class Node final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_out<std::uint64_t> arrival{"arrival"};   ///< how often it has come to the barrier
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< how often the barrier has let it go on
  sc_core::sc_port<DivisionPort> division{"division"};
  sc_core::sc_port<CollectorPort> collector{"collector"};

  Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number);

  void begin(const isa::FrameHeader& frame);

  [[nodiscard]] NodeClocks account() const { return stays_.clocks(time_.now()); }
  /// Adds what it has done.
  void tell(FrameAccount& counted) const;

  /// The colour that it holds for a pixel of the picture.
  [[nodiscard]] std::uint32_t colour(std::uint32_t x, std::uint32_t y) const {
    return image_[std::size_t{y / nodes_.height} * image_columns_ + x / nodes_.width];
  }

 private:
  /// A subsegment's, as it came over the bus.
  struct List {
    isa::Region region;
    std::vector<isa::Instruction> instructions;
  };

  void on_word();
  void take(const isa::Command& command);
  void work();
  void prune(const std::vector<isa::Region>& parts);
  void share(const std::vector<isa::Region>& parts);
  void send(const isa::Region& part, std::span<const isa::Instruction> list);
  void send(const isa::Command& command, bool last);
  void render(const List& list);
  void clear_segment();
  void spend(NodeActivity activity, std::uint64_t clocks);
  void wait_for_others();

  void store(const isa::Region& region, const NodePixels& own, std::span<const std::uint32_t> colours);

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;  ///< and memory bits of a pixel
  const std::uint32_t number_;   ///< row by row
  const std::uint32_t bus_width_;
  const std::uint32_t bus_word_clocks_;

  isa::FrameHeader frame_;
  std::uint32_t image_columns_ = 0;
  std::vector<std::uint32_t> image_;  ///< colours of its pixels of the picture

  isa::WireDecoder decoder_;
  bool receiving_ = false;             ///< a segment's data from the display processor
  isa::Region segment_;                ///< the last that has come
  std::uint64_t primitive_words_ = 0;  ///< of that
  std::uint64_t halfspace_words_ = 0;
  std::vector<List> lists_;         ///< of the segment's subsegments, as they come
  std::size_t lists_received_ = 0;  ///< whole ones
  sc_core::sc_event segment_received_{"segment_received"};
  sc_core::sc_event list_received_{"list_received"};

  std::uint64_t words_ = 0;     ///< sent, of all frames
  std::uint64_t arrivals_ = 0;  ///< at the barrier, of all frames

  std::uint64_t first_word_ = 0;  ///< sent before the frame
  std::uint64_t box_tests_ = 0;
  std::uint64_t halfspace_tests_ = 0;
  Stays<NodeActivity, node_activity_names.size()> stays_;
};

}  // namespace csgsim::multi_processor
