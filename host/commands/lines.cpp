#include "host/commands/lines.h"

#include <fmt/format.h>

#include <concepts>
#include <optional>

#include "host/commands/grammar.h"
#include "host/read/limits.h"
#include "host/read/number.h"

namespace csgsim::commands {

namespace {

/// Collects the items that the grammar's actions produce.
class Reader {
 public:
  explicit Reader(read::Source& source) : source_(source) {}

  void add(Kind kind, std::string_view text) {
    if (++items_ > read::max_values)
      source_.fail(to_offset(text.data()),
                   fmt::format("more than {} words, numbers and signs; split the model", read::max_values));
    Item item{kind, text, 0, to_offset(text.data())};
    if (kind == Kind::number) {
      const std::optional<double> number = read::parse_number(text);
      if (!number)
        source_.fail(item.offset, fmt::format("number out of range: {} exceeds the range of doubles; correct it",
                                              read::shown(text)));
      item.number = *number;
    }
    line_.push_back(item);
  }

  void end_line() {
    if (!line_.empty()) lines_.push_back(std::move(line_));
    line_.clear();
  }

  [[noreturn]] void fail(const char* at) {
    const std::uint32_t offset = to_offset(at);
    const char found = source_.text()[offset];
    const std::string shown = found > ' ' && found <= '~'
                                  ? fmt::format("`{}`", found)
                                  : fmt::format("byte 0x{:02x}", static_cast<unsigned char>(found));
    source_.fail(
        offset,
        fmt::format("expected a name, a number or one of = + - * ( ), found {}; a comment begins with #", shown));
  }

  std::vector<std::vector<Item>> finish() {
    end_line();
    return std::move(lines_);
  }

 private:
  [[nodiscard]] std::uint32_t to_offset(const char* at) const {
    return static_cast<std::uint32_t>(at - source_.text().data());
  }

  read::Source& source_;
  std::vector<Item> line_;
  std::vector<std::vector<Item>> lines_;
  std::size_t items_ = 0;
};

template <typename Rule>
struct Action : tao::pegtl::nothing<Rule> {};

template <Kind kind>
struct Adds {
  template <typename Input>
  static void apply(const Input& in, Reader& reader) {
    reader.add(kind, in.string_view());
  }
};

template <>
struct Action<grammar::word> : Adds<Kind::word> {};
template <>
struct Action<grammar::number> : Adds<Kind::number> {};
template <>
struct Action<grammar::sign> : Adds<Kind::sign> {};
template <>
struct Action<grammar::line_end> {
  static void apply0(Reader& reader) { reader.end_line(); }
};

template <typename Rule>
struct Control : tao::pegtl::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, Reader& reader) {
    reader.fail(in.current());
  }
};

}  // namespace

std::vector<std::vector<Item>> split_lines(read::Source& source) {
  const std::string_view text = source.text();
  tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy> input(text.data(), text.size(), "");
  Reader reader(source);
  tao::pegtl::parse<grammar::file, Action, Control>(input, reader);
  return reader.finish();
}

}  // namespace csgsim::commands
