#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/divide.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/records.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// Takes the model into its memory, transforms its planes and broadcasts its tree. Then for each segment it holds all
/// primitives against it, and the half-spaces of those that touch it; waits until the nodes have done with the segment
/// before, and broadcasts what is left. It does not divide while the nodes work, unless it divides ahead. Where the
/// records of a segment do not fit the nodes, their half-spaces stay here, and nodes ask for them one by one. Where the
/// model does not fit its own memory, it reads planes from the host whenever it tests them; where what a segment leaves
/// does not, it tests the segment again as it broadcasts that.
class DisplayProcessor final : public sc_core::sc_module {
 public:
  sc_core::sc_in<HostWord> host{"host"};
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< barriers
  sc_core::sc_out<std::uint64_t> frames{"frames"};     ///< that are drawn

  DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of the model that comes from the host from the next delta on.
  void begin();

  /// What it has done, and its stages.
  [[nodiscard]] FrameAccount counted() const;

  /// For waves.
  [[nodiscard]] std::string_view activity() const { return name_of(stays_.now()); }
  [[nodiscard]] const isa::Region& segment() const { return segment_; }  ///< at hand; without pixels before the first

 private:
  void on_host_word();
  void on_bus_word();
  void work();
  void draw();
  void receive_model();
  void spend(DisplayActivity activity, std::uint64_t clocks);
  division::Candidates prune(const isa::Region& segment);
  void take_request(const BusRequest& sent);
  void answer_request();
  [[nodiscard]] std::uint64_t far_plane_clocks() const;
  void draw_segment(const isa::Region& segment);
  void broadcast_frame();
  void broadcast(const isa::Region& segment, bool is_active);
  [[nodiscard]] std::uint64_t memory_words(const Records& records) const;
  void begin_broadcast();
  void end_broadcast();
  void send(const isa::Command& command, bool last);
  void send(const Records& records, WordKind kind, bool last);
  void send(const BusRequest& word);
  void wait_for_nodes();

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;
  const std::uint32_t bus_width_;
  std::uint64_t bits_taken_ = 0;      ///< from the host
  std::uint64_t model_bytes_ = 0;     ///< as the host says
  std::vector<std::uint8_t> memory_;  ///< the model's bytes that have come
  division::DisplayModel model_;
  std::optional<division::Divider> divider_;  ///< once the model is in
  bool has_planes_ = true;                    ///< in its memory
  std::uint64_t model_words_ = 0;             ///< of its memory, that the model takes
  std::uint64_t frame_words_ = 0;             ///< of a node's memory
  division::Candidates left_;                 ///< of the segment that was broadcast last
  bool is_far_ = false;                       ///< half-spaces of that segment have stayed here
  division::BitWriter request_;               ///< of a node, as much as has come
  bool is_asked_ = false;                     ///< a request has come
  std::uint64_t words_ = 0;                   ///< sent, of all frames
  std::uint64_t barriers_ = 0;                ///< that the nodes come to with what has been sent, of all frames
  std::uint64_t lists_to_come_ = 0;           ///< of the segment, from the nodes
  bool is_list_ = false;                      ///< the message on the bus has commands of one
  std::uint64_t drawn_ = 0;
  isa::Region segment_;  ///< that was divided last
  sc_core::sc_event start_{"start"};
  sc_core::sc_event model_received_{"model_received"};
  sc_core::sc_event asked_{"asked"};

  std::uint64_t first_word_ = 0;  ///< sent before the frame
  FrameAccount counted_;
  Stays<DisplayActivity, display_activity_names.size()> stays_;
};

}  // namespace csgsim::multi_processor
