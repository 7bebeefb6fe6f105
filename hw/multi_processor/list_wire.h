#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/list_form.h"

namespace csgsim::multi_processor {

/// Bits of a command of a list, and of the numbers in one of its instructions, its own first.
std::uint64_t entry_bits(const isa::Command& command, const ListForm& form);
std::vector<unsigned> entry_numbers(const isa::Instruction& instruction, const ListForm& form);

/// Words of the bus for a command of the list of `square`. `model`: as the node has it; number n is that of plane n.
std::vector<isa::LinkWord> entry_words(const isa::Command& command, const ListForm& form,
                                       const division::DisplayModel& model, const isa::Region& square,
                                       unsigned word_bits);

/// The receiving end.
class ListReader {
 public:
  explicit ListReader(unsigned word_bits) : word_bits_(word_bits), plain_(word_bits) {}

  /// The next word; returns the command that ends with it, if one does. Throws InputError as isa::WireDecoder does, and
  /// for the number of no half-space.
  std::optional<isa::Command> take(const isa::LinkWord& word, const ListForm& form,
                                   const division::DisplayModel& model);

 private:
  [[nodiscard]] std::optional<isa::Instruction> expression(const ListForm& form, const division::DisplayModel& model);

  unsigned word_bits_;
  isa::WireDecoder plain_;
  isa::Region square_;               ///< of the list that comes
  std::vector<isa::LinkWord> held_;  ///< words of the command at hand
  bool is_plain_ = false;            ///< it is none with an expression
};

}  // namespace csgsim::multi_processor
