#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::read {

/// The text of a file and the places in it. A byte-order mark does not count as a column.
class Source {
 public:
  /// Both views must outlive the source. `imports_from`: see read::Options. Throws InputError if the text is longer
  /// than `max_file_bytes`.
  Source(std::string_view text, std::string_view name, const std::filesystem::path& imports_from = {});

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// A file that the model names, from the model's folder. Throws InputError, at a byte, if it may not be read.
  std::filesystem::path file(std::string_view file, std::size_t offset);

  /// Those that were named, in order.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

  /// Line and column, in characters of UTF-8, of a byte. Cheap when asked for places from first to last.
  [[nodiscard]] model::Location locate(std::size_t offset);

  /// Tells `name:line:column: message` on standard error.
  void tell(std::size_t offset, std::string_view message);

  /// Throws InputError: `name:line:column: message`.
  [[noreturn]] void fail(std::size_t offset, std::string_view message);

 private:
  std::string_view text_;
  std::string_view name_;
  std::filesystem::path folder_;        ///< the model's
  std::filesystem::path imports_from_;  ///< complete, of plain parts
  std::vector<std::filesystem::path> files_;
  model::Location known_{1, 1};   ///< the place of the byte at known_offset_
  std::size_t known_offset_ = 0;  ///< everything before it is counted
};

/// A name from the file as a message may show it: cut short if it is long.
std::string shown(std::string_view name);

/// All of a file. Throws InputError if it cannot be read or is longer than `max_file_bytes`.
std::string load(const std::string& path);

}  // namespace csgsim::read
