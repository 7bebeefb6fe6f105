#include "sim/rtl/program_memory.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>

#include "hw/link/frame_words.h"

namespace csgsim::rtl {

namespace {

constexpr unsigned digit_bits = 4;

/// Appends the hexadecimal digits of a word, highest first.
void append_word(std::string& text, const isa::LinkWord& word, unsigned link_width) {
  for (unsigned digit = (link_width + digit_bits - 1) / digit_bits; digit-- > 0;) {
    const unsigned first = digit * digit_bits;
    fmt::format_to(std::back_inserter(text), "{:x}", word.number(first, digit_bits));
  }
  text += '\n';
}

}  // namespace

ProgramMemory program_memory(const isa::Program& program, unsigned link_width) {
  const link::FrameWords frame = link::frame_words(program, link_width);
  ProgramMemory memory;
  for (const isa::LinkWord& word : frame.words) append_word(memory.words, word, link_width);
  const auto number_bits = static_cast<unsigned>(std::bit_width(frame.words.size()));
  for (const std::size_t begin : frame.begins)
    fmt::format_to(std::back_inserter(memory.begins), "{:0{}x}\n", begin, (number_bits + digit_bits - 1) / digit_bits);
  memory.word_count = frame.words.size();
  memory.begin_count = frame.begins.size();
  return memory;
}

}  // namespace csgsim::rtl
