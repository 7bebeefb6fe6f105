#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>

#include "hw/link/receiver.h"
#include "hw/machines/machine.h"
#include "hw/scan_line/activity.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/systemc/clocked_module.h"
#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// Counts of a queue in the current frame, or in the last one.
struct EntryCounts {
  std::uint64_t packets = 0;      ///< packets of instructions
  std::uint64_t max_packets = 0;  ///< maximum number of packets of a line
  /// Number of lines whose mark entered too late: more clocks after the previous mark than the refresh allows.
  std::uint64_t late_lines = 0;
};

/// The entry of a chain. Its receiver assembles a command from the link while the previous packet enters. In the first
/// clock in which no packet is entering, the entry takes the command, and its packet enters, one beat per clock. A mark
/// waits until the previous mark is far enough ahead that the refresh path will be free (mark_spacing), and stalls the
/// packets behind it.
class PacketQueue final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_out<Beat> entry{"entry"};
  sc_core::sc_out<bool> busy{"busy"};  ///< whether the marks of some lines have not entered yet
  sc_core::sc_fifo_out<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  /// Number of frames of which all marks in this chain have entered.
  sc_core::sc_out<std::uint64_t> through{"through"};

  PacketQueue(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t chain);

  /// Lets the next mark enter immediately, without the minimum distance from the previous mark. Called when no mark is
  /// in the cells.
  void forget_mark() { marked_ = false; }

  /// Begins a frame with the next clock. All marks of the previous frame must have entered.
  void begin(const PictureLines& frame);

  /// Whether all marks of the frame have entered.
  [[nodiscard]] bool all_marks_entered() const { return line_ >= frame_.lines.size(); }

  [[nodiscard]] const EntryCounts& counts() const { return counts_; }
  [[nodiscard]] const ActivityCounter& counter() const { return counter_; }   ///< counter of the frame that began last
  [[nodiscard]] std::string_view activity() const { return counter_.now(); }  ///< shown in waves

 private:
  void on_clock() override;
  LineActivity act();
  void take(const isa::Command& command);
  void take_packet(const Packet& packet);
  [[nodiscard]] bool may_enter() const;
  void end_packet();
  void end_line();

  const machines::Machine machine_;
  const Figures figures_;
  const CellShape cell_;
  const std::uint32_t chain_;
  link::Receiver receiver_;
  PictureLines frame_;
  std::uint64_t budget_ = 0;
  std::size_t line_ = 0;
  std::uint32_t index_ = 0;   ///< index of the instruction in its line
  isa::Linear squares_;       ///< coefficients of the preceding `squares` instruction, if any
  bool begins_line_ = false;  ///< whether the next packet is the line's first, which clears
  /// Used alternately, because a packet has left the entry when the second packet after it arrives.
  std::array<Packet, 2> packets_;
  std::size_t packet_ = 0;         ///< index of the packet that arrived last
  std::optional<Beat> beat_;       ///< the beat that enters next
  std::uint64_t line_clocks_ = 0;  ///< clocks since the last mark was in cell 0, or the frame began
  std::uint64_t mark_clocks_ = 0;  ///< clocks since the last mark was in cell 0, of this or an earlier frame
  bool marked_ = false;            ///< whether any mark has been in cell 0
  std::uint64_t frames_through_ = 0;
  EntryCounts counts_;
  ActivityCounter counter_;
};

}  // namespace csgsim::scan_line
