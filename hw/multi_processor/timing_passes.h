#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"

/// Analytic model of how the lists of a segment are sent when they do not fit the nodes' memory at once.
namespace csgsim::multi_processor {

/// The part of a subsegment's list that its node sends without a pause.
struct Piece {
  std::size_t subsegment = 0;  ///< index within the segment
  std::size_t first = 0;       ///< first instruction of the list
  std::size_t count = 0;       ///< number of instructions
  bool ends = false;           ///< this piece completes the list
};

/// A node's transmission from one grant of the bus to its last word.
struct Message {
  std::size_t node = 0;
  std::uint64_t divided = 0;   ///< clocks in which the node extends its list before it requests the bus
  std::uint64_t reads = 0;     ///< half-spaces that the node reads over the bus in these clocks
  std::uint64_t words = 0;     ///< words on the bus
  std::optional<Piece> piece;  ///< none if a node has no room for the first command
  bool pauses = false;         ///< all nodes render what they have received, and the sender continues
};

/// A segment from the division of the first list to the arrival of the last one.
struct Passes {
  bool is_remote = false;              ///< half-spaces stay with the display processor
  ListForm form;                       ///< form of all lists
  std::vector<std::uint64_t> divided;  ///< clocks of each list before the first is sent
  std::vector<Message> messages;
};

/// Memory of a node that the records of frame and segment leave free.
struct ListRoom {
  std::uint64_t words = 0;
  bool is_remote = false;  ///< half-spaces stay with the display processor
};

/// Throws InputError if there is no room for any list.
ListRoom list_room(Subsegments parts, const ModelSizes& sizes, const machines::Machine& machine);

/// Form of the lists of a segment. `is_remote`: its half-spaces stay with the display processor.
ListForm list_form(Subsegments parts, bool is_remote, const ModelSizes& sizes, const machines::Machine& machine);

/// The form in which lists of any segment take longest.
ListForm longest_form(const ModelSizes& sizes, const machines::Machine& machine);

/// Words and clocks of the bus to request and receive a half-space that stays with the display processor.
struct ReadClocks {
  std::uint64_t request_words = 0;
  std::uint64_t answer_words = 0;
  std::uint64_t request = 0;
  std::uint64_t answer = 0;

  [[nodiscard]] std::uint64_t clocks() const { return request + answer; }
};

ReadClocks read_clocks(const ModelSizes& sizes, const machines::Machine& machine);

/// Plans the transmissions of a segment's lists.
Passes plan_passes(Subsegments parts, const ModelSizes& sizes, const machines::Machine& machine);

}  // namespace csgsim::multi_processor
