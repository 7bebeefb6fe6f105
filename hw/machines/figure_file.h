// Reads parameters from TOML.
// Used by hw/process and hw/processors.
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

/// Schema of one key of a parameter file: a table with `value`, `unit`, `provenance` and `source`, and for a number
/// optionally its range: `low`, `high` and the reason, `range`.
struct FigureForm {
  std::string_view key;
  std::string_view unit;
  std::int64_t least = 0;                     ///< minimum value
  std::int64_t most = 0;                      ///< maximum value
  std::span<const std::string_view> names{};  ///< if not empty, the value is one of these strings, counted from 0
  std::optional<std::int64_t> ideal{};        ///< meaning of `value = "ideal"`, if that is allowed
  std::optional<std::int64_t> priced{};       ///< meaning of `value = "processor"`, if that is allowed
};

/// A parameter as read from a file.
struct ReadFigure {
  std::size_t form = 0;    ///< index of its form
  std::int64_t value = 0;  ///< within the range of the form
  Figure figure;
};

/// A description in TOML: texts and parameters, each with its provenance. Errors are InputErrors with file:line:column.
/// Include this header in source files only, like toml_text.h.
class FigureFile {
 public:
  /// `changed`: if not empty, the file itself is valid, so that all errors are due to changed parameters: they are
  /// thrown as ChangeErrors whose text begins with `changed`.
  FigureFile(const toml::table& root, std::string_view file, std::string changed = {});

  /// The non-empty string at that key, made printable().
  [[nodiscard]] std::string text(std::string_view key) const;

  /// All parameters in the order of the file. Throws unless each form occurs once and all other keys are in `words`.
  [[nodiscard]] std::vector<ReadFigure> figures(std::span<const FigureForm> forms,
                                                std::span<const std::string_view> words) const;

  /// Throws an error at the value of the key, or at the beginning of the file if there is no such key.
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;

 private:
  const toml::table& root_;
  std::string_view file_;
  std::string changed_;
};

}  // namespace csgsim::machines
