#include "host/read/source.h"

#include <fmt/format.h>

#include "host/read/limits.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"

namespace csgsim::read {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

constexpr InputKind model_file{"a .csg file", max_file_bytes, "split the model"};

}  // namespace

Source::Source(std::string_view text, std::string_view name) : text_(text), name_(name) {
  check_length(name_, text_.size(), model_file);
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

model::Location Source::locate(std::size_t offset) {
  if (offset < known_offset_) {
    known_ = {1, 1};
    known_offset_ = 0;
  }
  for (; known_offset_ < offset; ++known_offset_) {
    if (text_[known_offset_] == '\n') {
      ++known_.line;
      known_.column = 1;
    } else if (starts_character(text_[known_offset_])) {
      ++known_.column;
    }
  }
  return known_;
}

void Source::fail(std::size_t offset, std::string_view message) {
  const model::Location place = locate(offset);
  throw InputError(fmt::format("{}:{}:{}: {}", name_, place.line, place.column, message));
}

std::string shown(std::string_view name) {
  constexpr std::size_t longest = 40;
  if (name.size() <= longest) return std::string(name);
  return std::string(name.substr(0, longest)) + "...";
}

std::string load(const std::string& path) { return read_file(path, model_file); }

}  // namespace csgsim::read
