#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/change_error.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// One key of a file of figures: a table with `value`, `unit`, `provenance` and `source`.
struct FigureForm {
  std::string_view key;
  std::string_view unit;
  std::int64_t least = 0;                     ///< of the value
  std::int64_t most = 0;                      ///< of the value
  std::span<const std::string_view> names{};  ///< the value is one of these strings, counted from 0
  std::optional<std::int64_t> ideal{};        ///< what `value = "ideal"` stands for, where it may be said
};

/// A figure as a file gives it.
struct ReadFigure {
  std::size_t form = 0;    ///< which of the forms it has
  std::int64_t value = 0;  ///< within its range
  Figure figure;
};

/// A description in TOML: words, and figures, each of which says where it comes from. Errors are InputErrors with
/// file:line:column. For source files, as toml_text.h.
class FigureFile {
 public:
  /// Where `changed` says something, the file is known to be right, and what is wrong is what was changed: errors are
  /// ChangeErrors that begin with it.
  FigureFile(const toml::table& root, std::string_view file, std::string changed = {});

  /// The string at that key, not empty, as people may see it.
  [[nodiscard]] std::string text(std::string_view key) const;

  /// Every figure, each form's once, in the order of the file. Besides there are the words alone.
  [[nodiscard]] std::vector<ReadFigure> figures(std::span<const FigureForm> forms,
                                                std::span<const std::string_view> words) const;

  /// Throws what is wrong with the value at the key, or with the whole file where there is no such key.
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;

 private:
  const toml::table& root_;
  std::string_view file_;
  std::string changed_;
};

}  // namespace csgsim::machines
