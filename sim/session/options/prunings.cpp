#include "sim/session/options/prunings.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "hw/base/nearest.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

struct NamedPruning {
  std::string_view name;
  bool csg::Pruning::*is_done;
};

constexpr auto named = std::to_array<NamedPruning>({{"space", &csg::Pruning::space},
                                                    {"picture", &csg::Pruning::picture},
                                                    {"separation", &csg::Pruning::separation},
                                                    {"halfspaces", &csg::Pruning::halfspaces},
                                                    {"hidden", &csg::Pruning::hidden},
                                                    {"sets", &csg::Pruning::sets},
                                                    {"early-out", &csg::Pruning::early_out},
                                                    {"near", &csg::Pruning::near}});

constexpr std::string_view left_out = "no-";

const NamedPruning& named_by(std::string_view word, bool is_left_out) {
  const std::string_view name = is_left_out ? word.substr(left_out.size()) : word;
  const auto found = std::ranges::find(std::span(named), name, &NamedPruning::name);
  if (found != std::span(named).end()) return *found;
  throw UsageError(unknown_name_text("pruning", word, pruning_words()) + "; join several with +");
}

csg::Pruning all_or_none(bool is_done) {
  csg::Pruning pruning = csg::Pruning();
  for (const NamedPruning& one : named) pruning.*one.is_done = is_done;
  return pruning;
}

}  // namespace

csg::Pruning parse_pruning(const std::string& text) {
  if (text == automatic_pruning || text == "all" || text == "none") return all_or_none(text != "none");
  const std::vector<std::string_view> words = split(text, "+");
  const bool are_left_out = words.front().starts_with(left_out);
  csg::Pruning pruning = all_or_none(are_left_out);
  for (const std::string_view word : words) {
    const bool is_left_out = word.starts_with(left_out);
    pruning.*named_by(word, is_left_out).is_done = !is_left_out;
    if (is_left_out == are_left_out) continue;
    throw UsageError("'" + text +
                     "' mixes prunings to apply and prunings to leave out; use one form: space+hidden, or " +
                     "no-space+no-hidden");
  }
  return pruning;
}

std::vector<std::string> parse_prunings(const std::string& text) {
  std::vector<std::string> prunings = parse_words(text);
  for (const std::string& one : prunings) parse_pruning(one);
  return prunings;
}

std::vector<std::string> pruning_words() {
  std::vector<std::string> words{std::string(automatic_pruning), "all", "none"};
  for (const NamedPruning& one : named) words.emplace_back(one.name);
  for (const NamedPruning& one : named) words.push_back(std::string(left_out) + std::string(one.name));
  return words;
}

}  // namespace csgsim::session
