#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/list_form.h"

namespace csgsim::multi_processor {

/// Number of bits of a command in a list.
std::uint64_t entry_bits(const isa::Command& command, const ListForm& form);

/// Widths in bits of the numbers of an instruction in a list, the opcode first.
std::vector<unsigned> entry_widths(const isa::Instruction& instruction, const ListForm& form);

/// Bus words of a command in the list of the subsegment `square`. `model`: the node's copy of the model; half-space
/// number n refers to its plane n.
std::vector<isa::LinkWord> entry_words(const isa::Command& command, const ListForm& form,
                                       const division::DisplayModel& model, const isa::Region& square,
                                       unsigned word_bits);

/// Decodes the received commands of a list.
class ListReader {
 public:
  explicit ListReader(unsigned word_bits) : word_bits_(word_bits), plain_(word_bits) {}

  /// Accepts the next word; returns the command that it completes, if any. Throws InputError as isa::WireDecoder does,
  /// and for an invalid half-space number.
  std::optional<isa::Command> take(const isa::LinkWord& word, const ListForm& form,
                                   const division::DisplayModel& model);

 private:
  [[nodiscard]] std::optional<isa::Instruction> decode_expression(const ListForm& form,
                                                                  const division::DisplayModel& model);

  unsigned word_bits_;
  isa::WireDecoder plain_;
  isa::Region square_;               ///< region of the list being received
  std::vector<isa::LinkWord> held_;  ///< words of the current command
  bool is_plain_ = false;            ///< the current command has no expression
};

}  // namespace csgsim::multi_processor
