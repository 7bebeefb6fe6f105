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

/// The list of a subsegment, or a part of that list that was received before a pause.
struct List {
  isa::Region region;
  std::size_t first = 0;  ///< instructions of the subsegment in earlier parts
  std::vector<isa::Instruction> instructions;
  bool ends = false;  ///< no part follows
  ListForm form;

  [[nodiscard]] bool begins() const { return first == 0; }
};

/// Pixels of a subsegment that a node has rendered in part.
struct SavedPixels {
  isa::Region region;
  PixelMemory pixels;  ///< empty if there is no such subsegment
};

/// State of a node while it renders.
struct Rendering {
  const List* list = nullptr;           ///< null if the node renders no list
  std::uint64_t start_clock = 0;        ///< clock of its start, counted since the simulation began
  const PixelMemory* before = nullptr;  ///< the pixels before the list part; empty for the first part of a list
};

/// A processor of the array, which holds the pixels of the picture interleaved over the array in both directions. The
/// model's tree arrives over the bus, then the survivors of each segment, from which the node divides the subsegment of
/// its own number. When all nodes have divided, each sends its list in turn; then all render subsegment by subsegment,
/// each its own pixels, and wait for the slowest after each.
/// If the lists do not fit the memory of all nodes, the sender stops before a command that some node has no room for;
/// all nodes render what they have received, and the sender continues. The same happens if a node has no room to extend
/// its own list before it has sent the existing part. If half-spaces stay with the display processor, nodes divide in
/// turn and read each half-space that they test over the bus.
/// No other unit sees a node's pixels until the node reaches the barrier, so the node executes a whole subsegment at
/// once and then sleeps for the clocks that this takes.
class Node final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_out<std::uint64_t> arrival{"arrival"};   ///< number of arrivals at the barrier
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< number of releases by the barrier
  sc_core::sc_port<RoomPort> room{"room"};
  sc_core::sc_port<CollectorPort> collector{"collector"};

  Node(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t number);

  /// Begins a frame.
  void begin();

  [[nodiscard]] NodeClocks account() const { return activities_.clocks(time_.now()); }
  /// Adds the node's counts to `frame_counts`.
  void add_counts(FrameAccount& frame_counts) const;

  // Shown in waves.
  [[nodiscard]] std::string_view activity() const { return name_of(activities_.now()); }
  [[nodiscard]] const Rendering& rendering() const { return rendering_; }
  /// Elapsed clocks of the current work, without turns of the screen.
  [[nodiscard]] std::uint64_t work_elapsed() const {
    return work_done_ + (is_working_ ? time_.now() - working_since_ : 0);
  }
  [[nodiscard]] bool is_stalled() const { return screen_.is_in_turn(time_.now()); }
  [[nodiscard]] const SavedPixels& saved() const { return saved_; }
  /// Whether the node holds colours, either of the current frame or of the previous frame.
  [[nodiscard]] bool has_image() const { return !image_.empty(); }

  /// Colour that the node holds for a pixel of the picture.
  [[nodiscard]] std::uint32_t colour(std::uint32_t x, std::uint32_t y) const {
    return image_[std::size_t{y / nodes_.height} * image_columns_ + x / nodes_.width];
  }

 private:
  class FarDatapath;

  void on_word();
  void take_from_display(const BusRequest& bus_word);
  void take_from_node(const BusRequest& bus_word);
  void begin_receiving();
  void take_record(const BusRequest& bus_word);
  void begin_frame();
  void begin_segment(const isa::Region& segment);
  void take_list_command(const isa::Command& command);
  void work();
  void prune();
  void draw_lists();
  void send_list();
  void divide_remotely();
  void append_command(const isa::Command& command);
  void send_built();
  ReadHalfspace read_halfspace(const HalfspaceId& id);
  [[nodiscard]] std::uint64_t screen_turn_clocks(std::uint64_t start_clock);
  void take_answer(const BusRequest& bus_word);
  void send_word(WordKind kind, const isa::LinkWord& word, bool is_last);
  void send(const isa::Command& command, bool is_last);
  void render_lists();
  void render(const List& list);
  void clear(const isa::Region& region);
  void clear_segment();
  void spend(NodeActivity activity, std::uint64_t clocks);
  void advance(std::uint64_t clocks);
  void wait_for_others();
  void begin_sharing(std::uint64_t clock);
  void update_room_line();
  [[nodiscard]] std::uint64_t room_for_lists() const;
  [[nodiscard]] ListForm choose_list_form() const;

  void store_image(const isa::Region& region, const NodePixels& node_pixels, const std::vector<std::uint32_t>& colours);
  [[nodiscard]] NodePixels own_pixels(const isa::Region& region) const;

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;  ///< shape, and memory bits of a pixel
  const std::uint32_t number_;   ///< row by row
  const std::uint32_t bus_width_;
  const std::uint32_t bus_word_clocks_;
  const std::uint32_t bus_latency_;

  std::uint32_t image_columns_ = 0;
  std::vector<std::uint32_t> image_;  ///< colours of the node's pixels of the picture

  isa::WireDecoder decoder_;
  ListReader entries_;
  ListForm form_;  ///< form of the segment's lists
  RecordReader records_;
  bool receiving_ = false;  ///< whether a transmission of the display processor is in progress
  isa::Region segment_;     ///< received last
  bool is_active_ = false;  ///< the segment has records
  bool is_remote_ = false;  ///< half-spaces stay with the display processor
  std::vector<isa::Region> parts_;
  OwnList own_;                     ///< list of the node's own subsegment
  std::vector<List> lists_;         ///< parts received and not yet rendered
  std::uint64_t list_words_ = 0;    ///< memory words of lists_
  List open_;                       ///< next part of a list that has not been received completely
  std::size_t lists_received_ = 0;  ///< complete lists
  bool sending_ = false;            ///< it is the node's turn to send
  bool sharing_ = false;            ///< lists are on the bus
  bool paused_ = false;             ///< the last message ended with a pause
  SavedPixels saved_;
  sc_core::sc_event segment_received_{"segment_received"};
  sc_core::sc_event message_ended_{"message_ended"};
  bool awaiting_answer_ = false;      ///< waits for a half-space
  division::BitWriter answer_;        ///< bits received of the answer
  std::uint64_t dividing_since_ = 0;  ///< clock, since the simulation began, in which dividing resumed
  sc_core::sc_event answered_{"answered"};

  Rendering rendering_;
  ScreenTurns screen_;
  bool is_working_ = false;          ///< working, not stalled by a turn of the screen
  std::uint64_t work_done_ = 0;      ///< clocks of the current work before it last resumed
  std::uint64_t working_since_ = 0;  ///< clock, since the simulation began, in which the current work last resumed
  std::uint64_t frame_start_ = 0;    ///< clock in which the frame began

  std::uint64_t words_ = 0;     ///< words sent, over all frames
  std::uint64_t arrivals_ = 0;  ///< arrivals at the barrier, over all frames

  std::uint64_t first_word_ = 0;  ///< words sent before the frame
  division::Counts tests_;
  std::uint64_t passes_ = 0;                ///< number of times that lists were rendered
  std::uint64_t turn_dividing_clocks_ = 0;  ///< clocks of dividing after the first list was sent
  ActivityCounter<NodeActivity, node_activity_names.size()> activities_;
};

}  // namespace csgsim::multi_processor
