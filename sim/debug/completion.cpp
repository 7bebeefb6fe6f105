#include "sim/debug/completion.h"

#include <algorithm>

namespace csgsim::debug {

Completion complete(std::string_view line, std::span<const std::string> words) {
  const std::size_t blank = line.find_last_of(" \t");
  const std::string_view begun = line.substr(blank == std::string_view::npos ? 0 : blank + 1);
  Completion completion;
  for (const std::string& word : words)
    if (word.starts_with(begun)) completion.candidates.push_back(word);
  if (completion.candidates.empty()) return completion;
  std::string common = completion.candidates.front();
  for (const std::string& word : completion.candidates) {
    const auto [end, other] = std::mismatch(common.begin(), common.end(), word.begin(), word.end());
    common.erase(end, common.end());
  }
  completion.insert = common.substr(begun.size());
  if (completion.candidates.size() == 1) completion.insert += ' ';
  return completion;
}

}  // namespace csgsim::debug
