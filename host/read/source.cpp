#include "host/read/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "host/read/limits.h"
#include "hw/isa/error.h"

namespace csgsim::read {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

[[noreturn]] void fail_too_long(std::string_view name) {
  throw InputError(fmt::format("{}: longer than {} MiB; split the model", name, max_file_bytes >> 20U));
}

[[noreturn]] void fail_to_read(const std::string& path, int error) {
  throw InputError(fmt::format("{}: cannot be read: {}", path, std::generic_category().message(error)));
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

Source::Source(std::string_view text, std::string_view name) : text_(text), name_(name) {
  if (text_.size() > max_file_bytes) fail_too_long(name_);
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

std::string load(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(fmt::format("{}: is a directory; name a .csg file", path));
  }
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  std::string text;
  const std::uintmax_t expected = std::filesystem::file_size(path, ignored);
  if (!ignored && expected > max_file_bytes) fail_too_long(path);
  if (!ignored) text.reserve(static_cast<std::size_t>(expected));
  std::array<char, std::size_t{1} << 16U> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    if (text.size() + count > max_file_bytes) fail_too_long(path);
    text.append(block.data(), count);
  }
  if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
  return text;
}

}  // namespace csgsim::read
