#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/counts.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/collector.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_wire.h"
#include "hw/multi_processor/own_list.h"
#include "hw/multi_processor/pixel_memory.h"
#include "hw/multi_processor/records.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/room_line.h"
#include "hw/multi_processor/screen_turns.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// What a subsegment asks for, or as much of it as came over the bus before all rendered what had come.
struct List {
  isa::Region region;
  std::size_t first = 0;  ///< instructions of the subsegment that came before
  std::vector<isa::Instruction> instructions;
  bool ends = false;  ///< nothing comes after
  ListForm form;

  [[nodiscard]] bool begins() const { return first == 0; }
};

/// Pixels of a subsegment that a node has rendered in part.
struct Kept {
  isa::Region region;
  PixelMemory pixels;  ///< none where there is no such subsegment
};

/// What a node is at while it renders.
struct Rendering {
  const List* list = nullptr;           ///< null while it renders none
  std::uint64_t begun = 0;              ///< clock, since the simulation began
  const PixelMemory* before = nullptr;  ///< of its pixels; empty where the list begins
};

/// A processor of the array, which holds every so-many-th pixel of every so-many-th row of the picture. The tree of the
/// model comes over the bus, then what each segment leaves of it, from which the node divides the subsegment of its own
/// number. When all have done so, each sends its list in turn; then all render subsegment by subsegment, each its own
/// pixels, and wait for the slowest after each. Where the lists do not fit the memory of all nodes, who sends stops
/// before a command that has no room in some node, all render what has come, and the sender goes on; so it is where a
/// node has no room to make more of its own list before it has sent what there is. Where half-spaces stay with the
/// display processor, nodes divide in turn, and read each one that they test over the bus. What a node does to its
/// pixels no other part can see until it comes to the barrier: it does all of a subsegment at once and then sleeps for
/// the clocks that this takes.
class Node final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_out<std::uint64_t> arrival{"arrival"};   ///< how often it has come to the barrier
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< how often the barrier has let it go on
  sc_core::sc_port<RoomPort> room{"room"};
  sc_core::sc_port<CollectorPort> collector{"collector"};

  Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number);

  void begin();

  [[nodiscard]] NodeClocks account() const { return stays_.clocks(time_.now()); }
  /// Adds what it has done.
  void tell(FrameAccount& counted) const;

  // For waves.
  [[nodiscard]] std::string_view activity() const { return name_of(stays_.now()); }
  [[nodiscard]] const Rendering& rendering() const { return rendering_; }
  /// Clocks of what it does that have gone by, without those of turns of the screen.
  [[nodiscard]] std::uint64_t worked() const { return worked_ + (is_working_ ? time_.now() - works_from_ : 0); }
  [[nodiscard]] bool stands_still() const { return screen_.has(time_.now()); }
  [[nodiscard]] const Kept& kept() const { return kept_; }
  /// It holds colours, of a frame that has begun or of the one before.
  [[nodiscard]] bool has_image() const { return !image_.empty(); }

  /// The colour that it holds for a pixel of the picture.
  [[nodiscard]] std::uint32_t colour(std::uint32_t x, std::uint32_t y) const {
    return image_[std::size_t{y / nodes_.height} * image_columns_ + x / nodes_.width];
  }

 private:
  class FarDatapath;

  void on_word();
  void take_from_display(const BusRequest& sent);
  void take_from_node(const BusRequest& sent);
  void begin_receiving();
  void take_record(const BusRequest& sent);
  void begin_frame();
  void begin_segment(const isa::Region& segment);
  void take_of_list(const isa::Command& command);
  void work();
  void prune();
  void draw_lists();
  void send_list();
  void divide_from_afar();
  void put(const isa::Command& command);
  void send_made();
  ReadHalfspace read_halfspace(const HalfspaceName& name);
  [[nodiscard]] std::uint64_t turns_since(std::uint64_t begun);
  void take_answer(const BusRequest& sent);
  void send_word(WordKind kind, const isa::LinkWord& word, bool last);
  void send(const isa::Command& command, bool last);
  void render_lists();
  void render(const List& list);
  void clear(const isa::Region& region);
  void clear_segment();
  void spend(NodeActivity activity, std::uint64_t clocks);
  void go_on(std::uint64_t clocks);
  void wait_for_others();
  void begin_sharing(std::uint64_t clock);
  void tell_room();
  [[nodiscard]] std::uint64_t room_for_lists() const;
  [[nodiscard]] ListForm form_of_lists() const;

  void store(const isa::Region& region, const NodePixels& own, const std::vector<std::uint32_t>& colours);
  [[nodiscard]] NodePixels own_pixels(const isa::Region& region) const;

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;  ///< and memory bits of a pixel
  const std::uint32_t number_;   ///< row by row
  const std::uint32_t bus_width_;
  const std::uint32_t bus_word_clocks_;
  const std::uint32_t bus_latency_;

  std::uint32_t image_columns_ = 0;
  std::vector<std::uint32_t> image_;  ///< colours of its pixels of the picture

  isa::WireDecoder decoder_;
  ListReader entries_;
  ListForm form_;  ///< of the segment's lists
  RecordReader records_;
  bool receiving_ = false;  ///< from the display processor
  isa::Region segment_;     ///< the last that has come
  bool is_active_ = false;  ///< with records
  bool is_far_ = false;     ///< half-spaces stay with the display processor
  std::vector<isa::Region> parts_;
  OwnList own_;                     ///< of the node's own subsegment
  std::vector<List> lists_;         ///< as much as has come, and is not rendered
  std::uint64_t list_words_ = 0;    ///< of that, in memory
  List open_;                       ///< a list that has not come as a whole: what comes next of it
  std::size_t lists_received_ = 0;  ///< whole ones
  bool sends_ = false;              ///< it is the node's turn
  bool shares_ = false;             ///< lists travel
  bool paused_ = false;             ///< the last message said so
  Kept kept_;
  sc_core::sc_event segment_received_{"segment_received"};
  sc_core::sc_event message_ended_{"message_ended"};
  bool asks_ = false;               ///< for a half-space
  division::BitWriter answer_;      ///< as much of it as has come
  std::uint64_t divides_from_ = 0;  ///< clock, since the simulation began, in which it went on with dividing
  sc_core::sc_event answered_{"answered"};

  Rendering rendering_;
  ScreenTurns screen_;
  bool is_working_ = false;        ///< in no turn of the screen
  std::uint64_t worked_ = 0;       ///< clocks, of what it does, before it last went on
  std::uint64_t works_from_ = 0;   ///< clock, since the simulation began, in which it did so
  std::uint64_t frame_begun_ = 0;  ///< the same of the frame

  std::uint64_t words_ = 0;     ///< sent, of all frames
  std::uint64_t arrivals_ = 0;  ///< at the barrier, of all frames

  std::uint64_t first_word_ = 0;  ///< sent before the frame
  division::Counts tests_;
  std::uint64_t passes_ = 0;           ///< in which lists were rendered
  std::uint64_t divided_in_turn_ = 0;  ///< clocks of dividing after lists began to travel
  Stays<NodeActivity, node_activity_names.size()> stays_;
};

}  // namespace csgsim::multi_processor
