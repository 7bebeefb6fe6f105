#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/systemc/wire.h"

/// Signals between the modules.
namespace csgsim::multi_processor {

/// Kind of a word on the control bus, carried by a separate wire.
enum class WordKind : std::uint8_t {
  command,  ///< part of a command of hw/isa/wire.h
  frame,    ///< part of a record of the frame (records.h)
  segment,  ///< part of a record of a segment
  heads,    ///< like `segment`, for a segment whose half-spaces stay with the display processor
  request,  ///< part of a node's request for one of these half-spaces
  answer,   ///< part of the record that is sent in reply
  pause,    ///< the sender pauses: all nodes render what they have received
};

/// Whether the word belongs to the records of a segment.
constexpr bool is_segment_record(WordKind kind) { return kind == WordKind::segment || kind == WordKind::heads; }

/// Whether the word belongs to the read of a half-space by a node that divides.
constexpr bool is_halfspace_read(WordKind kind) { return kind == WordKind::request || kind == WordKind::answer; }

/// A master's word for the bus.
struct BusRequest {
  std::uint64_t number = 0;  ///< sequence number among the master's words, from 1; 0 before the first
  WordKind kind = WordKind::command;
  bool last = false;  ///< last word of the master's message
  isa::LinkWord word;

  constexpr bool operator==(const BusRequest&) const = default;
};

/// The word that was just delivered to all units.
struct BusLines {
  std::uint64_t number = 0;  ///< sequence number among all words, from 1; 0 before the first
  std::uint32_t master = 0;  ///< sender of the word
  BusRequest sent;

  constexpr bool operator==(const BusLines&) const = default;
};

/// A word of the host's link.
struct HostWord {
  std::uint64_t number = 0;  ///< sequence number among all words, from 1; 0 before the first
  isa::LinkWord word;

  constexpr bool operator==(const HostWord&) const = default;
};

// Required by sc_signal; never called (hw/systemc/wire.h).
template <systemc::OneOf<BusRequest, BusLines, HostWord> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <systemc::OneOf<BusRequest, BusLines, HostWord> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

/// The display processor is master 0 of the bus; node n is master n + 1.
inline constexpr std::uint32_t display_master = 0;

constexpr std::uint32_t master_of(std::uint32_t node) { return node + 1; }

}  // namespace csgsim::multi_processor
