// Words of a link as received by a machine: a byte with the width of the link minus 1, then the words, each in whole
// bytes.

#include "hw/isa/wire.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace isa = csgsim::isa;

namespace {

isa::LinkWord word_of(std::span<const std::uint8_t> bytes) {
  isa::LinkWord word;
  for (unsigned i = 0; i < bytes.size(); ++i) word.put(8 * i, 8, bytes[i]);
  return word;
}

void check_command(const isa::Command& command, unsigned link_width, const std::vector<isa::LinkWord>& words) {
  std::vector<isa::LinkWord> again;
  isa::encode(command, link_width, [&](const isa::LinkWord& word) { again.push_back(word); });
  fuzz::require(again == words, "a command is encoded in the words received");
  fuzz::require(again.size() == isa::wire_words(command, link_width),
                "a command takes the number of words for its bits");
}

}  // namespace

/// Any words either decode to commands that encode to the same words, or are rejected with one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::span<const std::uint8_t> rest(data, size);
  if (rest.empty()) return 0;
  const unsigned link_width = rest.front() + 1U;
  rest = rest.subspan(1);
  isa::WireDecoder decoder(link_width);
  std::vector<isa::LinkWord> words;
  while (!rest.empty()) {
    const auto bytes = rest.first(std::min<std::size_t>((link_width + 7) / 8, rest.size()));
    rest = rest.subspan(bytes.size());
    const isa::LinkWord word = word_of(bytes).slice(0, link_width);
    words.push_back(word);
    try {
      if (const std::optional<isa::Command> command = decoder.take(word)) check_command(*command, link_width, words);
    } catch (const csgsim::InputError& error) {
      fuzz::check_message(error);
      fuzz::require(decoder.is_between_commands(), "a new command begins after an error");
    }
    if (decoder.is_between_commands()) words.clear();
  }
  return 0;
}
