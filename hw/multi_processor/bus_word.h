#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/systemc/wire.h"

/// What is on the wires between the modules.
namespace csgsim::multi_processor {

/// What a word of the control bus is, which a wire beside it says.
enum class WordKind : std::uint8_t {
  command,  ///< part of a command of hw/isa/wire.h
  frame,    ///< part of a record of the frame (records.h)
  segment,  ///< part of a record of a segment
  heads,    ///< the same, of a segment whose half-spaces stay with the display processor
  request,  ///< part of a node's request for one of these
  answer,   ///< part of its record
  pause,    ///< no more now: all render what has come
};

/// Does it belong to what a segment leaves?
constexpr bool is_of_segment(WordKind kind) { return kind == WordKind::segment || kind == WordKind::heads; }

/// Does a node divide between this and what was on the bus before?
constexpr bool is_of_reading(WordKind kind) { return kind == WordKind::request || kind == WordKind::answer; }

/// A master's word for the bus.
struct BusRequest {
  std::uint64_t number = 0;  ///< of the master's words, from 1; 0 before the first
  WordKind kind = WordKind::command;
  bool last = false;  ///< of what the master has to say for now
  isa::LinkWord word;

  constexpr bool operator==(const BusRequest&) const = default;
};

/// The word that all have just got.
struct BusLines {
  std::uint64_t number = 0;  ///< of all words, from 1; 0 before the first
  std::uint32_t master = 0;  ///< who sent it
  BusRequest sent;

  constexpr bool operator==(const BusLines&) const = default;
};

/// A word of the host's link.
struct HostWord {
  std::uint64_t number = 0;  ///< of all words, from 1; 0 before the first
  isa::LinkWord word;

  constexpr bool operator==(const HostWord&) const = default;
};

// Which nobody calls (hw/systemc/wire.h).
template <systemc::OneOf<BusRequest, BusLines, HostWord> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <systemc::OneOf<BusRequest, BusLines, HostWord> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

/// The display processor is master 0 of the bus, node n is master n + 1.
inline constexpr std::uint32_t display_master = 0;

constexpr std::uint32_t master_of(std::uint32_t node) { return node + 1; }

}  // namespace csgsim::multi_processor
