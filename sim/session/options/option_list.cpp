#include "sim/session/options/option_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <type_traits>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

const std::string is_true = "true";
const std::string is_false = "false";

template <class Value>
struct Inner {
  using Type = Value;
};
template <class Value>
struct Inner<std::optional<Value>> {
  using Type = Value;
};

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  if (std::is_floating_point_v<Number> && text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Advice for a number followed by a unit, as in `20bits`; empty for other texts and for SI prefixes.
std::string unit_advice(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  std::string_view unit = text.substr(end);
  if (unit.starts_with(' ')) unit.remove_prefix(1);
  const bool is_unit = (unit == "s" || unit.size() > 1) && std::ranges::all_of(unit, is_letter);
  return end > 0 && is_unit ? fmt::format("; write the number alone: {}", text.substr(0, end)) : "";
}

template <class Number>
std::string number_problem(const std::string& text) {
  if (number_in<Number>(text)) return "";
  if constexpr (std::is_floating_point_v<Number>) return "'" + text + "' is not a number" + unit_advice(text);
  const bool is_digits = !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  if (!is_digits) return "'" + text + "' is not a whole number, 0 or more" + unit_advice(text);
  return fmt::format("'{}' is more than {}", text, std::numeric_limits<Number>::max());
}

std::string flag_problem(const std::string& text) {
  return text == is_true || text == is_false ? "" : "'" + text + "' is neither true nor false";
}

/// C strings end at a zero byte, so the rest of the text would be lost.
void refuse_zero_byte(const std::string& text) {
  if (text.find('\0') != text.npos)
    throw UsageError(text, "contains a zero byte, which a command line cannot hold; remove it");
}

std::string named_folder(const std::string& name) { return name.empty() ? "the name is empty; name a folder" : ""; }

/// What to add to a command line for a required option or operand.
std::string how_to_give(const Option& option, const std::string& request) {
  if (option.is_operand) return fmt::format("name it, as in csgsim {} {}", request, option.shown_name());
  const std::string_view value = known_option(option.key()).value;
  return fmt::format("add {} {}", option.names.front(), option.is_folder ? "FOLDER" : value.empty() ? "VALUE" : value);
}

/// Name of a value of the option in messages.
std::string kind_of(const Option& option) {
  std::string name = option.key();
  std::ranges::replace(name, '-', ' ');
  return name;
}

}  // namespace

std::string not_empty(const std::string& name) { return name.empty() ? "the name is empty; name a file" : ""; }

Option& Option::required() {
  is_required = true;
  return *this;
}

Option& Option::check(const Check& check) {
  checks_.push_back(check);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& all, const std::string& kind) {
  const std::string called = kind.empty() ? kind_of(*this) : kind;
  return words(all, [all, called](const std::string& word) {
    return std::ranges::find(all, word) != all.end() ? std::string() : unknown_name_text(called, word, all);
  });
}

Option& Option::list_of(const std::vector<std::string>& all, const std::string& kind) {
  return words(all, check_by_parsing([all, kind](const std::string& text) { parse_names(text, kind, all); }));
}

Option& Option::words(const std::vector<std::string>& words, const Check& check) {
  offered = words;
  return this->check(check);
}

Option& Option::folder() {
  is_folder = true;
  return check(named_folder);
}

Option& Option::between(std::uint64_t low, std::uint64_t high) {
  range = fmt::format("{} to {}", low, high);
  checks_.assign(1, [low, high](const std::string& text) {
    const std::optional<std::uint64_t> number = number_in<std::uint64_t>(text);
    const bool is_within = number && *number >= low && *number <= high;
    return is_within ? ""
                     : fmt::format("'{}' is not a whole number from {} to {}{}", text, low, high, unit_advice(text));
  });
  return *this;
}

Option& Option::excludes(const std::string& other) {
  excluded.push_back(other);
  return *this;
}

std::string Option::problem(std::span<const std::string> texts) const {
  const bool is_one = takes != Takes::texts && takes != Takes::flag;
  if (is_one && texts.size() > 1) return fmt::format("given {} times; give it once", texts.size());
  for (const std::string& text : texts) {
    for (const Check& check : checks_)
      if (std::string problem = check(text); !problem.empty()) return problem;
  }
  return "";
}

std::string Option::key() const {
  if (!is_operand) return shown_name().substr(2);
  std::string key = names.front();
  std::ranges::transform(key, key.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return key;
}

bool Option::is_called(std::string_view name) const {
  const auto is_name = [&](std::string_view one) { return one.starts_with("--") && one.substr(2) == name; };
  return is_operand ? key() == name : std::ranges::any_of(names, is_name);
}

std::string Option::shown_name() const {
  const auto is_long = [](const std::string& name) { return name.starts_with("--"); };
  const auto found = std::ranges::find_if(names, is_long);
  return found == names.end() ? names.front() : *found;
}

std::string Option::value_text() const { return fmt::format("{}", fmt::join(given, ",")); }

OptionValue Option::value() const {
  OptionValue value{{key(), takes}, is_operand, meaning, given};
  if (given.empty() && takes == Takes::flag) value.values = {is_false};
  if (given.empty() && !usual.empty()) value.values = {usual};
  return value;
}

Option& OptionList::add(const std::string& names, Takes takes, const std::string& meaning) {
  Option& option = options_.emplace_back();
  for (const std::string_view name : split(names, ",")) option.names.emplace_back(name);
  option.is_operand = !option.names.front().starts_with('-');
  option.takes = takes;
  option.meaning = meaning;
  return option;
}

template <class Value>
Option& OptionList::option(const std::string& names, Value& value, const std::string& meaning) {
  if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    Option& option = add(names, Takes::texts, meaning);
    option.take_ = [&value](const std::vector<std::string>& texts) { value = texts; };
    return option;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    Option& option = add(names, Takes::text, meaning);
    option.usual = value;
    option.take_ = [&value](const std::vector<std::string>& texts) { value = texts.front(); };
    return option;
  } else {
    using Number = typename Inner<Value>::Type;
    Option& option = add(names, std::is_floating_point_v<Number> ? Takes::number : Takes::whole_number, meaning);
    if constexpr (std::is_floating_point_v<Value>) option.usual = fmt::format("{:g}", value);
    if constexpr (std::is_integral_v<Value>) option.usual = fmt::format("{}", value);
    option.checks_.emplace_back(number_problem<Number>);
    option.take_ = [&value](const std::vector<std::string>& texts) {
      value = number_in<Number>(texts.front()).value();
    };
    return option;
  }
}

template Option& OptionList::option(const std::string&, std::string&, const std::string&);
template Option& OptionList::option(const std::string&, std::uint32_t&, const std::string&);
template Option& OptionList::option(const std::string&, double&, const std::string&);
template Option& OptionList::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option& OptionList::option(const std::string&, std::optional<std::uint32_t>&, const std::string&);
template Option& OptionList::option(const std::string&, std::optional<std::uint64_t>&, const std::string&);
template Option& OptionList::option(const std::string&, std::optional<double>&, const std::string&);

Option& OptionList::read_option(const std::string& names, const std::function<void(const std::string&)>& take,
                                const std::string& meaning) {
  Option& option = add(names, Takes::text, meaning);
  option.take_ = [take](const std::vector<std::string>& texts) { take(texts.front()); };
  return option;
}

Option& OptionList::flag(const std::string& names, bool& is_given, const std::string& meaning) {
  Option& option = add(names, Takes::flag, meaning);
  option.checks_.emplace_back(flag_problem);
  option.take_ = [&is_given](const std::vector<std::string>& texts) { is_given = texts.back() == is_true; };
  return option;
}

void OptionList::remove(const std::string& shown_name) {
  const auto found = std::ranges::find(options_, shown_name, &Option::shown_name);
  if (found == options_.end()) throw std::logic_error("no option " + shown_name + " to remove");
  options_.erase(found);
}

void OptionList::clear() {
  for (Option& option : options_) {
    option.given.clear();
    option.place.clear();
  }
  typed.clear();
}

const Option* OptionList::find(std::string_view key) const {
  const auto found = std::ranges::find_if(options_, [&](const Option& one) { return one.is_called(key); });
  return found == options_.end() ? nullptr : &*found;
}

Option* OptionList::find(std::string_view key) {
  const auto found = std::ranges::find_if(options_, [&](const Option& one) { return one.is_called(key); });
  return found == options_.end() ? nullptr : &*found;
}

Option& OptionList::find_required(std::string_view key) {
  Option* const option = find(key);
  if (option != nullptr && !option->is_operand) return *option;
  std::vector<std::string> known;
  for (const Option& one : options_)
    if (!one.is_operand) known.push_back(one.shown_name());
  throw UsageError(unknown_option_message(fmt::format("--{}", key), known, name_));
}

void OptionList::give(std::string_view key, const std::string& text) {
  Option& option = find_required(key);
  refuse_zero_byte(text);
  option.given.push_back(text);
}

void OptionList::give_flag(std::string_view key) {
  Option& option = find_required(key);
  if (option.takes != Takes::flag) throw UsageError(option.shown_name(), "needs a value");
  option.given.push_back(is_true);
}

void OptionList::give_operand(const std::string& text) {
  const auto takes_more = [](const Option& one) {
    return one.is_operand && (one.given.empty() || one.takes == Takes::texts);
  };
  const auto next = std::ranges::find_if(options_, takes_more);
  refuse_zero_byte(text);
  if (next == options_.end())
    throw UsageError(fmt::format("unexpected argument {}; see csgsim {} --help", text, name_));
  next->given.push_back(text);
}

void OptionList::give_words(std::span<const std::string> words) {
  bool is_operand = false;  // true for every word after `--`
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (is_operand || !word.starts_with("--")) {
      give_operand(word);
      continue;
    }
    if (word == "--") {
      is_operand = true;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(2, equals == word.npos ? word.npos : equals - 2);
    if (equals != word.npos) {
      give(key, word.substr(equals + 1));
    } else if (find_required(key).takes == Takes::flag || i + 1 == words.size()) {
      give_flag(key);
    } else {
      give(key, words[++i]);
    }
  }
}

const Option* OptionList::excluded_by(const Option& option) const {
  const auto excludes = [](const Option& one, const Option& other) {
    return std::ranges::find(one.excluded, other.shown_name()) != one.excluded.end();
  };
  const auto found = std::ranges::find_if(
      options_, [&](const Option& one) { return one.is_given() && (excludes(one, option) || excludes(option, one)); });
  return found == options_.end() ? nullptr : &*found;
}

void OptionList::apply_given() {
  for (const Option& option : options_) {
    if (!option.is_given()) continue;
    try {
      const std::string problem = option.problem(option.given);
      if (!problem.empty()) throw UsageError(option.shown_name(), problem);
      option.take_(option.given);
    } catch (const UsageError& error) {
      if (option.place.empty()) throw;
      throw InputError(option.place + ": " + error.what());
    }
  }
}

void OptionList::check_and_apply() {
  apply_given();
  for (const Option& option : options_) {
    if (option.is_required && !option.is_given())
      throw UsageError(option.shown_name() + " is required; " + how_to_give(option, name_));
    const Option* const other = option.is_given() ? excluded_by(option) : nullptr;
    if (other != nullptr)
      throw UsageError(option.shown_name() + " excludes " + other->shown_name() + "; leave one out");
  }
}

std::string OptionList::place_of(std::string_view message) const {
  for (const Option& option : options_) {
    const std::string name = option.shown_name();
    if (!option.place.empty() && message.starts_with(name) && message.find_first_of(": ", name.size()) == name.size())
      return option.place;
  }
  return {};
}

bool OptionList::is_given(std::string_view key) const {
  const Option* const option = find(key);
  return option != nullptr && option->is_given();
}

std::vector<GivenOption> OptionList::given() const {
  std::vector<GivenOption> given;
  for (const Option& option : options_) {
    if (option.is_operand || !option.is_given()) continue;
    given.push_back({option.key(), option.value_text(), option.value_text() == option.usual});
  }
  return given;
}

std::vector<OptionValue> OptionList::values() const {
  std::vector<OptionValue> values;
  for (const Option& option : options_) values.push_back(option.value());
  return values;
}

std::vector<SettableOption> OptionList::settable() const {
  std::vector<SettableOption> options;
  for (const Option& option : options_) options.push_back({option.key(), option.takes});
  return options;
}

std::vector<std::string> OptionList::words(std::span<const std::string_view> excluded_keys) const {
  std::vector<std::string> operands;
  std::vector<std::string> options;
  for (const Option& option : options_) {
    if (option.is_operand) {
      operands.insert(operands.end(), option.given.begin(), option.given.end());
    } else if (option.is_given() && std::ranges::find(excluded_keys, option.key()) == excluded_keys.end()) {
      if (option.takes == Takes::flag) {
        if (option.given.back() != is_false) options.push_back(option.shown_name());
        continue;
      }
      for (const std::string& value : option.given)
        for (std::string& word : option_words(option.key(), value)) options.push_back(std::move(word));
    }
  }
  const bool is_like_option = std::ranges::any_of(operands, [](const auto& one) { return one.starts_with('-'); });
  if (is_like_option) options.emplace_back("--");
  std::vector<std::string>& first = is_like_option ? options : operands;
  const std::vector<std::string>& then = is_like_option ? operands : options;
  first.insert(first.end(), then.begin(), then.end());
  first.insert(first.begin(), name_);
  return first;
}

std::vector<std::string> OptionList::arguments() const {
  if (!typed.empty()) return typed;
  std::vector<std::string> all = words();
  all.insert(all.begin(), "csgsim");
  return all;
}

std::vector<std::string> option_words(const std::string& name, const std::string& value) {
  if (value.starts_with('-')) return {"--" + name + "=" + value};
  return {"--" + name, value};
}

std::string shell_command(std::span<const std::string> words) {
  std::string command = "csgsim";
  for (const std::string& word : words) command += " " + shell_word(word);
  return command;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = nearest_similar(word, candidates);
  return nearest.empty() ? "" : fmt::format(" did you mean {}?", nearest);
}

}  // namespace csgsim::session
