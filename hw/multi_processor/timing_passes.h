#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"

/// How the lists of a segment travel where they do not fit the nodes' memory at once, worked out.
namespace csgsim::multi_processor {

/// As much of a subsegment's list as its node sends without a stop.
struct Piece {
  std::size_t subsegment = 0;  ///< of the segment
  std::size_t first = 0;       ///< instruction of the list
  std::size_t count = 0;       ///< instructions
  bool ends = false;           ///< with it the list has come as a whole
};

/// What its node has to say, from one grant of the bus to its last word.
struct Message {
  std::size_t node = 0;
  std::uint64_t divided = 0;   ///< clocks in which the node goes on with its list before it asks for the bus
  std::uint64_t reads = 0;     ///< in these, of half-spaces that it reads over the bus
  std::uint64_t words = 0;     ///< of the bus
  std::optional<Piece> piece;  ///< none where a node has no room before the first command
  bool pauses = false;         ///< all render what has come, and the sender goes on
};

/// A segment from the first list's division to the last one's arrival.
struct Passes {
  bool is_far = false;                 ///< half-spaces stay with the display processor
  ListForm form;                       ///< of all lists
  std::vector<std::uint64_t> divided;  ///< clocks of each list, before the first is sent
  std::vector<Message> messages;
};

/// What the records of the frame and of the segment leave of a node's memory.
struct ListRoom {
  std::uint64_t words = 0;
  bool is_far = false;  ///< half-spaces stay with the display processor
};

/// Throws InputError where that is too little for any list.
ListRoom list_room(Subsegments parts, const ModelSizes& sizes, const machines::Machine& machine);

/// Of the lists of a segment whose half-spaces stay, or do not stay, with the display processor.
ListForm list_form(Subsegments parts, bool is_far, const ModelSizes& sizes, const machines::Machine& machine);

/// The form, of any segment, in which lists take longest.
ListForm longest_form(const ModelSizes& sizes, const machines::Machine& machine);

/// Of a half-space that stays with the display processor: words and clocks of the bus for the request and for the
/// answer.
struct ReadClocks {
  std::uint64_t request_words = 0;
  std::uint64_t answer_words = 0;
  std::uint64_t request = 0;
  std::uint64_t answer = 0;

  [[nodiscard]] std::uint64_t clocks() const { return request + answer; }
};

ReadClocks read_clocks(const ModelSizes& sizes, const machines::Machine& machine);

Passes passes_of(Subsegments parts, const ModelSizes& sizes, const machines::Machine& machine);

}  // namespace csgsim::multi_processor
