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

/// The list that a node builds for its own subsegment: its start, the instructions, its end. Building stops when the
/// room for the list is full, and resumes when the built part has been sent.
class OwnList {
 public:
  explicit OwnList(const Figures& figures) : figures_(figures) {}

  /// Begins the list of the subsegment `part` of the segment whose records were received. The node's memory holds at
  /// most `room_words` words of the list at a time.
  void begin(const isa::Region& part, const RecordReader& records, const ListForm& form, std::uint64_t room_words);
  /// Begins an empty list, for a node without a subsegment.
  void clear();

  /// Builds until the list is complete or the next command has no room. Returns the clocks spent.
  std::uint64_t build();

  /// Begins a list whose commands are supplied with put(); each call requires has_room_for().
  void begin(std::uint64_t room_words);
  [[nodiscard]] bool has_room_for(const isa::Command& command) const { return words_ + words_of(command) <= room_; }
  void put(const isa::Command& command);

  /// Whether some commands are built but not sent.
  [[nodiscard]] bool has_unsent() const { return sent_ < built_; }
  /// Words of the commands that are built but not sent.
  [[nodiscard]] std::uint64_t words() const { return words_; }

  /// The next command to send; send() removes it from the node's memory.
  [[nodiscard]] const isa::Command& next() const { return commands_[sent_].command; }
  void send();

  /// Counts of the whole list.
  [[nodiscard]] const division::Counts& counts() const { return counts_; }

 private:
  struct Timed {
    isa::Command command;
    std::uint64_t start_clock = 0;  ///< clock of dividing after all tests that lead to the command
    std::uint64_t built = 0;        ///< clock of dividing after the command has been built
  };

  [[nodiscard]] std::uint64_t words_of(const isa::Command& command) const;

  const Figures figures_;
  ListForm form_;
  std::uint64_t room_ = 0;
  std::vector<Timed> commands_;
  division::Counts counts_;
  std::size_t built_ = 0;
  std::size_t sent_ = 0;
  std::uint64_t words_ = 0;
  std::uint64_t now_ = 0;  ///< elapsed clocks of dividing
};

}  // namespace csgsim::multi_processor
