#include "hw/wave/vcd_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace csgsim::wave {

namespace {

constexpr std::string_view clock_code = "!";    // code of variable `clock`
constexpr std::string_view number_code = "\"";  // code of variable `clock_number`

/// The n-th shortest code of printable characters after these two.
std::string make_code(std::size_t n) {
  constexpr std::size_t characters = 94;
  std::string code;
  for (n += 2; n > 0; n /= characters) code += static_cast<char>('!' + n % characters);
  return code;
}

std::vector<std::string_view> split_words(std::string_view name) {
  std::vector<std::string_view> words;
  for (std::size_t dot = 0; (dot = name.find('.')) != std::string_view::npos; name.remove_prefix(dot + 1))
    words.push_back(name.substr(0, dot));
  words.push_back(name);
  return words;
}

void put_text(std::string& out, std::string_view shown) {
  out += 's';
  if (shown.empty()) out += '-';
  for (const char c : shown) {
    if (c > ' ' && c <= '~' && c != '\\') {
      out += c;
    } else {
      fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  out += ' ';
}

void put_number(std::string& out, const Number& number, unsigned width) {
  if (width > 1) out += 'b';
  if (!number) {
    out += 'z';
  } else if (width == 1) {
    out += *number != 0 ? '1' : '0';
  } else {
    for (auto bit = std::max(static_cast<int>(std::bit_width(*number)), 1); bit-- > 0;)
      out += (*number >> bit & 1U) != 0 ? '1' : '0';
  }
  if (width > 1) out += ' ';
}

}  // namespace

VcdWriter::VcdWriter(std::string_view top, std::vector<Tap> taps, std::uint64_t period_ps,
                     std::function<void(std::string_view)> write)
    : taps_(std::move(taps)), shown_(taps_.size()), period_(period_ps), out_(std::move(write)) {
  for (std::size_t i = 0; i < taps_.size(); ++i) codes_.push_back(make_code(i));
  write_header(top);
  for (std::string& code : codes_) code += '\n';
}

void VcdWriter::write_header(std::string_view top) {
  auto out = std::back_inserter(out_.text);
  fmt::format_to(out, "$version csgsim $end\n$timescale 1 ps $end\n$scope module {} $end\n", top);
  fmt::format_to(out, "$var wire 1 {} clock $end\n$var wire 64 {} clock_number [63:0] $end\n", clock_code, number_code);
  std::vector<std::string_view> open;
  for (std::size_t i = 0; i < taps_.size(); ++i) {
    std::vector<std::string_view> words = split_words(taps_[i].name);
    const std::string_view own = words.back();
    words.pop_back();
    const auto [left, entered] = std::mismatch(open.begin(), open.end(), words.begin(), words.end());
    for (auto scope = left; scope != open.end(); ++scope) out_.text += "$upscope $end\n";
    for (auto scope = entered; scope != words.end(); ++scope) fmt::format_to(out, "$scope module {} $end\n", *scope);
    open = std::move(words);
    if (taps_[i].show == Show::text) {
      fmt::format_to(out, "$var string 1 {} {} $end\n", codes_[i], own);
    } else if (taps_[i].width == 1) {
      fmt::format_to(out, "$var wire 1 {} {} $end\n", codes_[i], own);
    } else {
      fmt::format_to(out, "$var wire {} {} {} [{}:0] $end\n", taps_[i].width, codes_[i], own, taps_[i].width - 1);
    }
  }
  for (std::size_t scope = 0; scope <= open.size(); ++scope) out_.text += "$upscope $end\n";
  out_.text += "$enddefinitions $end\n";
}

void VcdWriter::write_time(std::uint64_t time) {
  out_.text += '#';
  out_.text += fmt::format_int(time).c_str();
  out_.text += '\n';
}

void VcdWriter::sample(std::uint64_t clock) {
  const bool follows = begun_ && clock == next_;
  if (begun_ && !follows) {
    write_time((next_ + 1) * period_);
    fmt::format_to(std::back_inserter(out_.text), "$dumpoff\nx{}\nbx {}\n", clock_code, number_code);
    for (std::size_t i = 0; i < taps_.size(); ++i) write_unknown(i);
    out_.text += "$end\n";
  }
  write_time((clock + 1) * period_);
  if (!follows) out_.text += begun_ ? "$dumpon\n" : "$dumpvars\n";
  fmt::format_to(std::back_inserter(out_.text), "1{}\nb{:b} {}\n", clock_code, clock, number_code);
  for (std::size_t i = 0; i < taps_.size(); ++i) write_value(i);
  if (!follows) out_.text += "$end\n";
  write_time((clock + 1) * period_ + period_ / 2);
  fmt::format_to(std::back_inserter(out_.text), "0{}\n", clock_code);
  begun_ = true;
  next_ = clock + 1;
  out_.write_if_long();
}

void VcdWriter::write_value(std::size_t tap) {
  const Tap& from = taps_[tap];
  Shown& shown = shown_[tap];
  const bool has_value = std::exchange(shown.state, Shown::State::value) == Shown::State::value;
  if (from.show == Show::text) {
    std::string text = from.text();
    if (has_value && text == shown.text) return;
    put_text(out_.text, text);
    shown.text = std::move(text);
  } else {
    const Number number = from.number();
    if (has_value && number == shown.number) return;
    put_number(out_.text, number, from.width);
    shown.number = number;
  }
  out_.text += codes_[tap];
}

void VcdWriter::write_unknown(std::size_t tap) {
  shown_[tap].state = Shown::State::unknown;
  out_.text += taps_[tap].show == Show::text ? "s- " : taps_[tap].width == 1 ? "x" : "bx ";
  out_.text += codes_[tap];
}

void VcdWriter::finish() {
  if (begun_) fmt::format_to(std::back_inserter(out_.text), "#{}\n", (next_ + 1) * period_);
  out_.write_all();
}

}  // namespace csgsim::wave
