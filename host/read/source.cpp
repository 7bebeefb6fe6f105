#include "host/read/source.h"

#include <fmt/format.h>

#include "host/read/limits.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"

namespace csgsim::read {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

constexpr InputKind model_file{"a .csg file", max_file_bytes, "split the model"};

/// Complete, without `.` and `..`, and without a slash at the end.
fs::path plain(const fs::path& path) {
  const fs::path normal = fs::absolute(path.empty() ? "." : path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

Source::Source(std::string_view text, std::string_view name, const fs::path& imports_from)
    : text_(text),
      name_(name),
      folder_(fs::path(name).parent_path()),
      imports_from_(plain(imports_from.empty() ? folder_ : imports_from)) {
  check_length(name_, text_.size(), model_file);
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

fs::path Source::file(std::string_view file, std::size_t offset) {
  fs::path path = (folder_ / file).lexically_normal();
  const fs::path below = plain(path).lexically_relative(imports_from_);
  if (file.empty() || below.empty() || *below.begin() == "..") {
    fail(offset, fmt::format("{} is not in the model's folder; put the file there, or below it, or name a folder that "
                             "both are in: --imports-from FOLDER",
                             printable(file)));
  }
  files_.push_back(path);
  return path;
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

void Source::tell(std::size_t offset, std::string_view message) {
  const model::Location place = locate(offset);
  tell_line(fmt::format("{}:{}:{}: {}", name_, place.line, place.column, message));
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
