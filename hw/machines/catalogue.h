// Loads descriptions by name or file.
// Used by hw/processors and hw/process.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/machines/built_in.h"
#include "hw/machines/names.h"

namespace csgsim::machines {

/// Loads descriptions by the name of a built-in one, or from a file. `Described` has the members `name` and `figures`,
/// its parameters. Include this header in source files only, because it includes {fmt}.
template <class Described>
struct Catalogue {
  std::string_view what;  ///< singular noun for messages
  std::span<const BuiltIn> built_in;
  Described (*read)(std::string_view text, std::string_view file, std::span<const std::string> changes);

  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> all;
    for (const BuiltIn& one : built_in) all.push_back(one.name);
    return all;
  }

  /// Loads a built-in description by name, or a file. An edited file of a built-in description gets a name that lists
  /// the edits. Throws InputError or ChangeError.
  [[nodiscard]] Described load(const std::string& spec) const {
    const std::string name(base_name(spec));
    const std::vector<std::string> changes = changes_of(spec);
    if (!file_of(spec).empty()) return load_file(name, changes);
    if (const BuiltIn* const found = find_built_in(name)) return read_built_in(*found, changes);
    throw InputError(
        fmt::format("{}; the name of a {} file must end in .toml", unknown_name_text(what, name, names()), what));
  }

 private:
  [[nodiscard]] const BuiltIn* find_built_in(std::string_view name) const {
    const auto found = std::ranges::find(built_in, name, &BuiltIn::name);
    return found == built_in.end() ? nullptr : &*found;
  }

  [[nodiscard]] Described read_built_in(const BuiltIn& known, std::span<const std::string> changes) const {
    return read(known.text, known.name, changes);
  }

  [[nodiscard]] Described load_file(const std::string& file, std::span<const std::string> changes) const {
    const std::string kind = fmt::format("a {} file, which ends in .toml", what);
    const std::string advice = fmt::format("a {} file is much shorter", what);
    const std::string text = read_file(file, InputKind{kind, std::size_t{1} << 20U, advice});
    Described described = read(text, file, changes);
    const std::string name = changes.empty() ? described.name : read(text, file, {}).name;
    if (const BuiltIn* const known = find_built_in(name))
      described.name = name + edits_suffix(described.figures, read_built_in(*known, {}).figures);
    return described;
  }
};

}  // namespace csgsim::machines
