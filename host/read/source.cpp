#include "host/read/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/messages.h"

namespace csgsim::read {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

}  // namespace

Source::Source(std::string_view text, std::string_view name, Options options)
    : text_(text),
      name_(name),
      folders_(fs::path(name).parent_path(), options.imports_from),
      imported_(std::move(options.imported)) {
  check_length(name_, text_.size(), model_file);
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

Source::Source(ImportedFile mesh, std::string_view name, Options options)
    : Source(R"(import(file = "mesh");)", name, std::move(options)) {
  mesh_ = std::move(mesh);
}

std::optional<ImportedFile> Source::import(std::string_view file, const InputKind& kind, std::string_view node,
                                           std::size_t offset) {
  if (mesh_) return mesh_;
  constexpr std::string_view hint = "put the file there, or below it, or name its folder: --imports-from FOLDER";
  const std::vector<ImportPlace> places = folders_.candidate_places(file);
  for (const auto& [place, is_inside] : places) {
    if (!is_inside) continue;
    std::optional<ImportedFile> found;
    try {
      const Descriptor opened = open_regular_file(place, kind);
      if (!opened.is_open()) continue;
      if (folders_.contains(opened)) found = ImportedFile{place, read_file(opened, place, kind)};
    } catch (const InputError& error) {
      fail(offset, error.what());
    }
    if (!found) fail(offset, fmt::format("{} is not in the model's folder: a link leads out of it; {}", file, hint));
    files_.push_back(place);
    if (imported_) imported_(found->bytes);
    return found;
  }
  if (std::ranges::any_of(places, [](const ImportPlace& place) { return !place.is_inside && place.exists(); }))
    fail(offset, fmt::format("{} is not in the model's folder; {}", file, hint));
  print_message(offset, fmt::format("warning: {} does not exist; {}() is empty, as in OpenSCAD", file, node));
  return std::nullopt;
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

std::string Source::placed(std::size_t offset, std::string_view message) {
  if (mesh_) return message.starts_with(name_) ? std::string(message) : fmt::format("{}: {}", name_, message);
  const model::Location place = locate(offset);
  return fmt::format("{}:{}:{}: {}", name_, place.line, place.column, message);
}

void Source::print_message(std::size_t offset, std::string_view message) { report_line(placed(offset, message)); }

void Source::warn_once(std::size_t offset, const std::string& message) {
  if (printed_.insert(message).second) print_message(offset, message);
}

void Source::fail(std::size_t offset, std::string_view message) { throw InputError(placed(offset, message)); }

std::string shown(std::string_view name) {
  constexpr std::size_t longest = 40;
  if (name.size() <= longest) return std::string(name);
  return std::string(name.substr(0, longest)) + "...";
}

}  // namespace csgsim::read
