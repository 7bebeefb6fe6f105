#include "sim/session/options/suggestions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <set>

#include "host/effects/rows.h"
#include "host/scene/schema.h"
#include "hw/base/nearest.h"
#include "hw/kinds/rows.h"
#include "hw/machines/kind.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/option_list.h"
#include "sim/session/options/option_table.h"

namespace csgsim::session {

namespace {

constexpr std::size_t max_suggestions = 3;

/// An option that does not exist, and what to write instead.
struct Replacement {
  std::string_view option;
  std::string_view instead;
};

/// Options of earlier versions, and frequent options of other programs.
constexpr auto replacements = std::to_array<Replacement>({
    {"--turn", "--orbit"},
    {"--without", "--pruning no-NAME"},
    {"--without-a", "--pruning-a no-NAME"},
    {"--without-b", "--pruning-b no-NAME"},
    {"--width", "--size WxH"},
    {"--height", "--size WxH"},
    {"--resolution", "--size WxH"},
    {"--version", "csgsim --version"},
    {"-?", "--help"},
    {"-v", "--verbose"},
});

bool is_known(std::span<const std::string> known, std::string_view word) {
  return std::ranges::find(known, word) != known.end();
}

/// Whether the words are equal except for case.
bool are_alike(std::string_view one, std::string_view other) {
  return one.size() == other.size() && edit_distance(one, other) == 0;
}

/// Every key that may be set; for tables of a list, the keys of the first table.
std::vector<std::string> all_keys() {
  std::set<std::string> keys;
  for (const machines::Kind* kind : kinds::all()) {
    for (const machines::FigureSchema& figure : kind->schema) keys.emplace(figure.key);
  }
  const auto add_section = [&](const scene::Section& section) {
    for (const scene::KeyValue& one : section.blank())
      keys.insert(fmt::format("{}.{}{}", section.name, section.is_list ? "0." : "", one.key.name));
  };
  for (const scene::Section& section : scene::common_sections()) add_section(section);
  for (const scene::Section& section : effects::sections()) {
    add_section(section);
    if (!section.is_list) keys.insert(fmt::format("{}.on", section.name));
  }
  return {keys.begin(), keys.end()};
}

bool has_part(std::string_view key, std::string_view part) {
  const std::vector<std::string_view> parts = split(key, ".");
  return std::ranges::any_of(parts, [&](std::string_view one) { return are_alike(one, part); });
}

/// The keys with a dotted part equal to `part`; only the switch `.on` if an effect has that name.
std::vector<std::string> keys_with(std::string_view part, std::span<const std::string> keys) {
  std::vector<std::string> found;
  for (const std::string& key : keys) {
    if (!has_part(key, part)) continue;
    if (are_alike(key, fmt::format("effects.{}.on", part))) return {key};
    if (found.size() < max_suggestions) found.push_back(key);
  }
  return found;
}

/// The parts of all keys.
std::vector<std::string_view> parts_of(std::span<const std::string> keys) {
  std::vector<std::string_view> parts;
  for (const std::string& key : keys) {
    for (const std::string_view part : split(key, ".")) parts.push_back(part);
  }
  return parts;
}

/// Known options that begin with the word, if it has at least three letters.
std::vector<std::string> options_that_begin_with(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t shortest = 5;
  std::vector<std::string> found;
  if (word.size() < shortest) return found;
  for (const std::string& one : known) {
    if (one.starts_with(word) && found.size() < max_suggestions) found.push_back(one);
  }
  return found;
}

/// The known option that a word with a single dash was meant to be: `-size`, or `-O`; empty if there is none.
std::string with_other_dashes(std::string_view word, std::span<const std::string> known) {
  if (word.starts_with("--")) return {};
  for (const std::string& one : known) {
    if (are_alike(one, word) || one == fmt::format("-{}", word)) return one;
  }
  return {};
}

std::string_view without_dashes(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// The known replacement of an option; empty if there is none, or if the request does not have it.
std::string_view replacement_for(std::string_view word, std::span<const std::string> known) {
  const auto found = std::ranges::find(replacements, word, &Replacement::option);
  if (found == replacements.end()) return {};
  const std::string_view option = found->instead.substr(0, found->instead.find(' '));
  return !option.starts_with('-') || is_known(known, option) ? found->instead : std::string_view();
}

/// `--set KEY=VALUE` for a word that is a key, or a part of one; empty if it is neither.
std::string set_for(std::string_view word) {
  if (word.empty() || is_option_name(word)) return {};
  const std::vector<std::string> keys = all_keys();
  const std::vector<std::string> found = is_known(keys, word) ? std::vector{std::string(word)} : keys_with(word, keys);
  if (found.empty()) return {};
  if (found.size() > 1) return fmt::format("--set KEY=VALUE with a key such as {}", alternatives_text(found));
  return fmt::format("--set {}={}", found.front(), found.front().ends_with(".on") ? "true" : "VALUE");
}

}  // namespace

std::string alternatives_text(std::span<const std::string> words) {
  if (words.empty()) return {};
  const std::span<const std::string> first = words.first(words.size() - 1);
  return first.empty() ? words.back() : fmt::format("{} or {}", fmt::join(first, ", "), words.back());
}

bool is_option_name(std::string_view word) {
  const KnownOption& option = known_option(word);
  const bool is_operand = option.subject.empty();
  return !option.name.empty() && !is_operand;
}

std::vector<std::string> suggested_keys(std::string_view key) {
  const std::vector<std::string> keys = all_keys();
  std::vector<std::string> with_part = keys_with(key, keys);
  if (!with_part.empty()) return with_part;
  const std::vector<std::string_view> candidates(keys.begin(), keys.end());
  const std::string_view near = nearest_similar(key, candidates);
  if (!near.empty()) return {std::string(near)};
  const std::string_view part = nearest_similar(key, parts_of(keys));
  return part.empty() ? std::vector<std::string>{} : keys_with(part, keys);
}

std::string suggested_option(std::string_view word, std::span<const std::string> known) {
  if (const std::string_view replaced = replacement_for(word, known); !replaced.empty()) return std::string(replaced);
  if (std::string other = with_other_dashes(word, known); !other.empty()) return other;
  if (const std::vector<std::string> longer = options_that_begin_with(word, known); !longer.empty())
    return alternatives_text(longer);
  if (is_known(known, "--set")) {
    if (std::string set = set_for(without_dashes(word)); !set.empty()) return set;
  }
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  return std::string(nearest_similar(word, candidates));
}

std::string unknown_option_message(std::string_view word, std::span<const std::string> known,
                                   std::string_view request) {
  const std::string meant = suggested_option(word, known);
  std::string advice;
  if (!meant.empty()) {
    advice = fmt::format(" did you mean {}?", meant);
  } else if (is_option_name(without_dashes(word))) {
    advice = fmt::format(" it is one of other commands, not of {};", request);
  }
  return fmt::format("there is no option {};{} see csgsim {} --help", word, advice, request);
}

}  // namespace csgsim::session
