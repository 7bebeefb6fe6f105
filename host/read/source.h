#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/model/tree.h"
#include "host/read/import_folders.h"
#include "host/read/limits.h"
#include "host/read/read.h"
#include "hw/base/input_file.h"
#include "hw/base/work.h"

namespace csgsim::read {

/// The limit on texts.
inline constexpr InputKind model_file{"a .csg file", max_file_bytes, "split the model"};

/// A file that the model imports, as it was when it was read.
struct ImportedFile {
  std::filesystem::path path;
  std::string bytes;
};

/// The text of a file and the places in it. A byte-order mark does not count as a column.
class Source {
 public:
  /// Both views must outlive the source. Throws InputError if the text is longer than `max_file_bytes`.
  Source(std::string_view text, std::string_view name, Options options = {});

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// A file that the model names. None, with a warning at the byte that `node` is empty, if there is none of the name.
  /// Throws InputError, at the byte, if it may not or cannot be read.
  std::optional<ImportedFile> import(std::string_view file, const InputKind& kind, std::string_view node,
                                     std::size_t offset);

  /// The files that were read, in order.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

  /// Whatever is made of the text is charged to it; see read::Options. Without a limit before.
  void charge_to(Work work) { work_ = std::move(work); }
  [[nodiscard]] const Work& work() const { return work_; }

  /// Line and column, in characters of UTF-8, of a byte. Cheap when asked for places from first to last.
  [[nodiscard]] model::Location locate(std::size_t offset);

  /// Tells `name:line:column: message` on standard error.
  void tell(std::size_t offset, std::string_view message);

  /// The same, unless that message has been told at another place.
  void tell_once(std::size_t offset, const std::string& message);

  /// Throws InputError: `name:line:column: message`.
  [[noreturn]] void fail(std::size_t offset, std::string_view message);

 private:
  std::string_view text_;
  std::string_view name_;
  ImportFolders folders_;
  std::function<void(std::string_view)> imported_;  ///< see Options
  std::vector<std::filesystem::path> files_;
  std::set<std::string> told_;    ///< by tell_once()
  model::Location known_{1, 1};   ///< the place of the byte at known_offset_
  std::size_t known_offset_ = 0;  ///< everything before it is counted
  Work work_;
};

/// A name from the file as a message may show it: cut short if it is long.
std::string shown(std::string_view name);

}  // namespace csgsim::read
