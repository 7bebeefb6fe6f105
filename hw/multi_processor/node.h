#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/division/divide.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/collector.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/records.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// What a subsegment asks for, as it came over the bus.
struct List {
  isa::Region region;
  std::vector<isa::Instruction> instructions;
};

/// What a node is at while it renders.
struct Rendering {
  const List* list = nullptr;  ///< null while it renders none
  std::uint64_t begun = 0;     ///< clock, since the simulation began
};

/// A processor of the array, which holds every so-many-th pixel of every so-many-th row of the picture. The tree of the
/// model comes over the bus, then what each segment leaves of it, from which the node divides the subsegment of its own
/// number. When all have done so, each sends its list in turn; then all render subsegment by subsegment, each its own
/// pixels, and wait for the slowest after each. What a node does to its pixels no other part can see until it comes to
/// the barrier: it does all of a subsegment at once and then sleeps for the clocks that this takes.
class Node final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_out<std::uint64_t> arrival{"arrival"};   ///< how often it has come to the barrier
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< how often the barrier has let it go on
  sc_core::sc_port<CollectorPort> collector{"collector"};

  Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number);

  void begin();

  [[nodiscard]] NodeClocks account() const { return stays_.clocks(time_.now()); }
  /// Adds what it has done.
  void tell(FrameAccount& counted) const;

  // For waves.
  [[nodiscard]] std::string_view activity() const { return name_of(stays_.now()); }
  [[nodiscard]] const Rendering& rendering() const { return rendering_; }
  /// It holds colours, of a frame that has begun or of the one before.
  [[nodiscard]] bool has_image() const { return !image_.empty(); }

  /// The colour that it holds for a pixel of the picture.
  [[nodiscard]] std::uint32_t colour(std::uint32_t x, std::uint32_t y) const {
    return image_[std::size_t{y / nodes_.height} * image_columns_ + x / nodes_.width];
  }

 private:
  void on_word();
  void begin_receiving();
  void take_record(const BusRequest& sent);
  void begin_frame();
  void take(const isa::Command& command);
  void work();
  void prune(const std::vector<isa::Region>& parts);
  void share(const std::vector<isa::Region>& parts);
  void send_list(const isa::Region& part);
  void send(const isa::Command& command, bool last);
  void render(const List& list);
  void clear(const isa::Region& region);
  void clear_segment();
  void spend(NodeActivity activity, std::uint64_t clocks);
  void wait_for_others();

  void store(const isa::Region& region, const NodePixels& own, const std::vector<std::uint32_t>& colours);
  [[nodiscard]] NodePixels own_pixels(const isa::Region& region) const;

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;  ///< and memory bits of a pixel
  const std::uint32_t number_;   ///< row by row
  const std::uint32_t bus_width_;
  const std::uint32_t bus_word_clocks_;

  std::uint32_t image_columns_ = 0;
  std::vector<std::uint32_t> image_;  ///< colours of its pixels of the picture

  isa::WireDecoder decoder_;
  RecordReader records_;
  bool receiving_ = false;          ///< from the display processor
  isa::Region segment_;             ///< the last that has come
  bool is_active_ = false;          ///< with records
  division::Divided divided_;       ///< the node's own subsegment of it
  std::vector<List> lists_;         ///< of the segment's subsegments, as they come
  std::size_t lists_received_ = 0;  ///< whole ones
  sc_core::sc_event segment_received_{"segment_received"};
  sc_core::sc_event list_received_{"list_received"};

  Rendering rendering_;

  std::uint64_t words_ = 0;     ///< sent, of all frames
  std::uint64_t arrivals_ = 0;  ///< at the barrier, of all frames

  std::uint64_t first_word_ = 0;  ///< sent before the frame
  division::Counts tests_;
  Stays<NodeActivity, node_activity_names.size()> stays_;
};

}  // namespace csgsim::multi_processor
