// The text of a model: positions, messages, imports.
// Used throughout host/read and by host/commands, sim/session, sim/studies and sim/viewer.
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

/// The size limit of model texts.
inline constexpr InputKind model_file{"a .csg file", max_file_bytes, "split the model"};

/// The size limit of a mesh that is a model.
inline constexpr InputKind mesh_file{"a mesh", max_file_bytes, "make it coarser"};

/// A file imported by the model, with its content.
struct ImportedFile {
  std::filesystem::path path;
  std::string bytes;
};

/// The text of a file and positions in it. A byte-order mark does not count as a column.
class Source {
 public:
  /// Both views must outlive the source. Throws InputError if the text is longer than `max_file_bytes`.
  Source(std::string_view text, std::string_view name, Options options = {});

  /// The text `import(...)` of a model that consists of this mesh. Messages have no position: they name the mesh.
  /// `name` must outlive the source.
  Source(ImportedFile mesh, std::string_view name, Options options);

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// Imports a file named by the model. Empty if the file does not exist; a warning at `offset` then reports that
  /// `node` is empty. Throws InputError at `offset` if reading the file is not allowed or fails.
  std::optional<ImportedFile> import(std::string_view file, const InputKind& kind, std::string_view node,
                                     std::size_t offset);

  /// The imported files, in order.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

  /// Sets the work counter that everything using this text is charged to; see read::Options. Without a call, work is
  /// unlimited.
  void set_work_counter(Work work) { work_ = std::move(work); }
  [[nodiscard]] const Work& work() const { return work_; }

  /// Line and column of a byte, counted in UTF-8 characters. Fast for ascending offsets.
  [[nodiscard]] model::Location locate(std::size_t offset);

  /// Prints `name:line:column: message` to standard error.
  void print_message(std::size_t offset, std::string_view message);

  /// Like print_message(), unless the same message was printed before at another position.
  void warn_once(std::size_t offset, const std::string& message);

  /// Throws InputError: `name:line:column: message`.
  [[noreturn]] void fail(std::size_t offset, std::string_view message);

 private:
  /// The message with its place.
  [[nodiscard]] std::string placed(std::size_t offset, std::string_view message);

  std::string_view text_;
  std::string_view name_;
  std::optional<ImportedFile> mesh_;  ///< set if it is the model
  ImportFolders folders_;
  std::function<void(std::string_view)> imported_;  ///< Options::imported
  std::vector<std::filesystem::path> files_;
  std::set<std::string> printed_;  ///< messages printed by warn_once()
  model::Location known_{1, 1};    ///< position of the byte at known_offset_
  std::size_t known_offset_ = 0;   ///< number of bytes before known_
  Work work_;
};

/// A name from the file as shown in messages: truncated if it is long.
std::string shown(std::string_view name);

}  // namespace csgsim::read
