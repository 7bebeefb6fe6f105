#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "host/model/tree.h"

namespace csgsim::read {

/// The text of a file and the places in it. A byte-order mark does not count as a column.
class Source {
 public:
  /// Both views must outlive the source. Throws InputError if the text is longer than `max_file_bytes`.
  Source(std::string_view text, std::string_view name);

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// Line and column, in characters of UTF-8, of a byte. Cheap when asked for places from first to last.
  [[nodiscard]] model::Location locate(std::size_t offset);

  /// Throws InputError: `name:line:column: message`.
  [[noreturn]] void fail(std::size_t offset, std::string_view message);

 private:
  std::string_view text_;
  std::string_view name_;
  model::Location known_{1, 1};   ///< the place of the byte at known_offset_
  std::size_t known_offset_ = 0;  ///< everything before it is counted
};

/// A name from the file as a message may show it: cut short if it is long.
std::string shown(std::string_view name);

/// All of a file. Throws InputError if it cannot be read or is longer than `max_file_bytes`.
std::string load(const std::string& path);

}  // namespace csgsim::read
