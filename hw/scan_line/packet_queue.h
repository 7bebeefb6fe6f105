#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"
#include "hw/scan_line/frame.h"
#include "hw/scan_line/words.h"

namespace csgsim::scan_line {

/// What a queue counted, clock by clock, of the frame that is running or ran last.
struct EntryCounts {
  std::uint64_t packets = 0;       ///< that entered, without marks
  std::uint64_t most_packets = 0;  ///< of a line
  std::uint64_t late_lines = 0;    ///< whose words took more clocks than the refresh gives a line
  std::uint64_t clocks = 0;        ///< in which a word was entering
  std::uint64_t waits = 0;         ///< in which a mark waited for the refresh path
};

/// The host's end of a chain. Sends the packets of the chain's lines word after word, each as long as a word takes to
/// enter; in the last of these clocks the word is in cell 0. A mark waits there until the mark before it is so far
/// ahead that the refresh path will be free (machines::mark_spacing), and what is behind it waits with it.
class PacketQueue final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_out<PacketWord> entry{"entry"};
  sc_core::sc_out<bool> busy{"busy"};  ///< a word is entering or waits
  sc_core::sc_fifo_out<EntryAccount> accounts{"accounts"};

  PacketQueue(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t chain);

  /// Starts with the next clock.
  void begin(const Frame& frame);

  [[nodiscard]] const EntryCounts& counts() const { return counts_; }

 private:
  void on_clock();
  void next_packet();
  void next_word();
  [[nodiscard]] bool may_enter() const;
  void end_packet();
  void end_line();

  const machines::Machine machine_;
  const std::uint32_t chain_;
  Frame frame_;
  std::uint64_t budget_ = 0;
  std::size_t line_ = 0;
  std::uint32_t index_ = 0;        ///< of the packet in its line
  PacketWord word_;                ///< that is entering
  std::uint16_t words_ = 0;        ///< of its packet
  std::uint32_t word_clocks_ = 0;  ///< since it began to enter
  std::uint64_t packet_clocks_ = 0;
  std::uint64_t line_clocks_ = 0;
  std::uint64_t since_mark_ = 0;  ///< clocks since the last mark was in cell 0
  EntryCounts counts_;
};

}  // namespace csgsim::scan_line
