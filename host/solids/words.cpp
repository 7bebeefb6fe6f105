#include "host/solids/words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

/// A word as quoted in messages.
std::string quote_word(std::string_view word) {
  constexpr std::size_t most = 40;
  return word.empty() ? "the end of the file" : fmt::format("'{}'", word.substr(0, most));
}

}  // namespace

void Words::skip_blanks(bool over_lines) {
  while (at_ < text_.size()) {
    const char here = text_[at_];
    if (here == '\n') {
      if (!over_lines) return;
      ++line_;
      line_at_ = at_ + 1;
    } else if (comment_ != 0 && here == comment_) {
      at_ = std::min(text_.find('\n', at_), text_.size());
      continue;
    } else if (blanks.find(here) == std::string_view::npos) {
      return;
    }
    ++at_;
  }
}

std::string_view Words::take() {
  word_at_ = at_;
  word_line_ = line_;
  word_line_at_ = line_at_;
  const auto ends = [&](char here) {
    return here == '\n' || (comment_ != 0 && here == comment_) || blanks.find(here) != std::string_view::npos;
  };
  while (at_ < text_.size() && !ends(text_[at_])) ++at_;
  return text_.substr(word_at_, at_ - word_at_);
}

std::string_view Words::next() {
  skip_blanks(true);
  return take();
}

std::string_view Words::next_on_line() {
  skip_blanks(false);
  if (at_ == text_.size() || text_[at_] == '\n') return {};
  return take();
}

void Words::skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

double Words::number_of(std::string_view word, std::string_view description) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_number = !digits.empty() && result.ptr == digits.data() + digits.size();
  // Numbers too small for a double are also out of range: a coordinate is never intentionally that small.
  if (!is_number || result.ec != std::errc{} || !std::isfinite(value)) {
    fail(fmt::format("{} must be a finite number, not {}; correct it", description, quote_word(word)));
  }
  return value;
}

std::uint32_t Words::count(std::string_view description, std::uint32_t maximum) {
  const std::string_view word = next();
  std::uint64_t value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || result.ec != std::errc{} || result.ptr != word.data() + word.size() || value > maximum) {
    fail(fmt::format("{} must be a whole number from 0 to {}, not {}; correct it", description, maximum,
                     quote_word(word)));
  }
  return static_cast<std::uint32_t>(value);
}

void Words::fail(std::string_view message) const {
  throw InputError(fmt::format("{}:{}:{}: {}", name_, word_line_, word_at_ - word_line_at_ + 1, message));
}

}  // namespace csgsim::solids
