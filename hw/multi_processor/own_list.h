#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/division/counts.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/list_form.h"
#include "hw/multi_processor/records.h"

namespace csgsim::multi_processor {

/// The list that a node makes of its own subsegment, a command after the other: the beginning, instructions, the end.
/// It goes on until the room for it is full, and again when what it has made is sent.
class OwnList {
 public:
  explicit OwnList(const Figures& figures) : figures_(figures) {}

  /// Of a subsegment of the segment whose records have come, in so many words at a time. Nothing is made yet.
  void begin(const isa::Region& part, const RecordReader& records, const ListForm& form, std::uint64_t room);
  /// Without a subsegment.
  void clear();

  /// Returns the clocks in which the list is made until it is whole, or the next command has no room.
  std::uint64_t make();

  /// Another way: a list is begun and its commands come from elsewhere, each where there is room for it.
  void begin(std::uint64_t room);
  [[nodiscard]] bool has_room_for(const isa::Command& command) const { return words_ + words_of(command) <= room_; }
  void put(const isa::Command& command);

  /// Something is made and not sent.
  [[nodiscard]] bool is_waiting() const { return sent_ < made_; }
  /// Words of what is made and not sent.
  [[nodiscard]] std::uint64_t words() const { return words_; }

  /// The next to be sent, and then no longer the node's own.
  [[nodiscard]] const isa::Command& next() const { return commands_[sent_].command; }
  void send();

  /// Of the whole list.
  [[nodiscard]] const division::Counts& counts() const { return counts_; }

 private:
  struct Timed {
    isa::Command command;
    std::uint64_t begun = 0;  ///< in the clocks of dividing, when all that leads to it is done
    std::uint64_t made = 0;
  };

  [[nodiscard]] std::uint64_t words_of(const isa::Command& command) const;

  const Figures figures_;
  ListForm form_;
  std::uint64_t room_ = 0;
  std::vector<Timed> commands_;
  division::Counts counts_;
  std::size_t made_ = 0;
  std::size_t sent_ = 0;
  std::uint64_t words_ = 0;
  std::uint64_t now_ = 0;  ///< of the clocks of dividing, how many have passed
};

}  // namespace csgsim::multi_processor
