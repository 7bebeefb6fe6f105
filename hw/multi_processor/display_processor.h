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

/// Receives the model into its memory, transforms its planes and broadcasts its tree. For each segment it tests all
/// primitives against the segment, and the half-spaces of those that touch it; waits until the nodes have finished the
/// previous segment; and broadcasts the survivors. Unless it divides ahead, it does not divide while the nodes work. If
/// the records of a segment do not fit the nodes, their half-spaces stay here, and nodes request them one by one. If
/// the model does not fit its own memory, it reads planes from the host whenever it tests them; if the survivors of a
/// segment do not fit, it tests the segment again while broadcasting.
class DisplayProcessor final : public sc_core::sc_module {
 public:
  sc_core::sc_in<HostWord> host{"host"};
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< number of barriers
  sc_core::sc_out<std::uint64_t> frames{"frames"};     ///< number of frames drawn

  DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of the model that the host sends from the next delta cycle on.
  void begin();

  /// Counts and stage clocks of the frame.
  [[nodiscard]] FrameAccount frame_counts() const;

  /// Shown in waves.
  [[nodiscard]] std::string_view activity() const { return name_of(activities_.now()); }
  [[nodiscard]] const isa::Region& segment() const { return segment_; }  ///< current segment; empty before the first

 private:
  void on_host_word();
  void on_bus_word();
  void work();
  void draw();
  void receive_model();
  void spend(DisplayActivity activity, std::uint64_t clocks);
  division::Candidates prune(const isa::Region& segment);
  void take_request(const BusRequest& bus_word);
  void answer_request();
  [[nodiscard]] std::uint64_t remote_plane_clocks() const;
  void draw_segment(const isa::Region& segment);
  void broadcast_frame();
  void broadcast_segment(const isa::Region& segment, bool is_active);
  [[nodiscard]] std::uint64_t memory_words(const Records& records) const;
  void begin_broadcast();
  void end_broadcast();
  void send(const isa::Command& command, bool is_last);
  void send(const Records& records, WordKind kind, bool is_last);
  void send(const BusRequest& word);
  void wait_for_nodes();

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;
  const std::uint32_t bus_width_;
  std::uint64_t bits_taken_ = 0;      ///< received from the host
  std::uint64_t model_bytes_ = 0;     ///< size of the model, sent by the host
  std::vector<std::uint8_t> memory_;  ///< bytes of the model received
  division::DisplayModel model_;
  std::optional<division::Divider> divider_;  ///< set once the model has been received
  bool has_planes_ = true;                    ///< the planes are in the display processor's memory
  std::uint64_t model_words_ = 0;             ///< words of its memory that the model occupies
  std::uint64_t frame_words_ = 0;             ///< words of a node's memory that the frame's records occupy
  division::Candidates survivors_;            ///< survivors of the segment broadcast last
  bool is_remote_ = false;                    ///< half-spaces of that segment stayed here
  division::BitWriter request_;               ///< bits received of a node's request
  bool request_pending_ = false;              ///< a request has been received
  std::uint64_t words_ = 0;                   ///< words sent, over all frames
  std::uint64_t barriers_ = 0;       ///< barriers that the nodes reach with what has been sent, over all frames
  std::uint64_t lists_to_come_ = 0;  ///< lists of the segment still to be sent by the nodes
  bool is_list_ = false;             ///< the message on the bus contains commands of a list
  std::uint64_t drawn_ = 0;
  isa::Region segment_;  ///< segment divided last
  sc_core::sc_event start_{"start"};
  sc_core::sc_event model_received_{"model_received"};
  sc_core::sc_event request_received_{"asked"};

  std::uint64_t first_word_ = 0;  ///< words sent before the frame
  FrameAccount counted_;
  ActivityCounter<DisplayActivity, display_activity_names.size()> activities_;
};

}  // namespace csgsim::multi_processor
