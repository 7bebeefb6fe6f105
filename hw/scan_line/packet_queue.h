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

/// What a queue counted, clock by clock, of the frame that is running or ran last.
struct EntryCounts {
  std::uint64_t packets = 0;       ///< of instructions
  std::uint64_t most_packets = 0;  ///< of a line
  std::uint64_t late_lines = 0;  ///< whose mark entered more clocks after the one before than the refresh gives a line
};

/// The entry of a chain. Its receiver gathers a command from the link while the packet of the one before enters; in the
/// first clock in which no packet is entering it takes the command, and the packet enters, a beat a clock. A mark waits
/// there until the mark before it is so far ahead that the refresh path will be free (mark_spacing), and what is behind
/// it waits with it.
class PacketQueue final : public systemc::ClockedModule {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_out<Beat> entry{"entry"};
  sc_core::sc_out<bool> busy{"busy"};  ///< there is a line whose mark has not entered
  sc_core::sc_fifo_out<EntryAccount> accounts{"accounts"};
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  sc_core::sc_out<std::uint64_t> through{"through"};  ///< frames all of whose marks here have entered, if there are any

  PacketQueue(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t chain);

  /// No mark is in the cells.
  void clear() { marked_ = false; }

  /// Starts with the next clock. All marks of the frame before have entered.
  void begin(const PictureLines& frame);

  /// All marks of the frame have entered.
  [[nodiscard]] bool is_through() const { return line_ >= frame_.lines.size(); }

  [[nodiscard]] const EntryCounts& counts() const { return counts_; }
  [[nodiscard]] const ActivityCounter& counter() const { return counter_; }   ///< of the frame that began last
  [[nodiscard]] std::string_view activity() const { return counter_.now(); }  ///< for waves

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
  std::uint32_t index_ = 0;        ///< of the instruction in its line
  isa::Linear squares_;            ///< of the instruction before, if they are its operand
  bool begins_line_ = false;       ///< the next packet is the line's first, and clears
  std::array<Packet, 2> packets_;  ///< in turn: the last has left the entry when the next but one comes
  std::size_t packet_ = 0;         ///< of these, the one that came last
  std::optional<Beat> beat_;       ///< that enters next
  std::uint64_t line_clocks_ = 0;  ///< since the last mark was in cell 0, or the frame began
  std::uint64_t mark_clocks_ = 0;  ///< since the last mark was in cell 0, of this frame or one before
  bool marked_ = false;            ///< one was
  std::uint64_t frames_through_ = 0;
  EntryCounts counts_;
  ActivityCounter counter_;
};

}  // namespace csgsim::scan_line
