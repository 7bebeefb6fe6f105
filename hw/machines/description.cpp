#include "hw/machines/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/machines/figure_changes.h"
#include "hw/machines/figure_error.h"
#include "hw/machines/figure_file.h"
#include "hw/machines/schema.h"

namespace csgsim::machines {

namespace {

constexpr std::string_view machine_words[] = {"name", "description", "kind"};

const Kind& find_kind(const FigureFile& file, std::span<const Kind* const> kinds) {
  const std::string kind = file.text("kind");
  const auto found = std::ranges::find(kinds, kind, &Kind::name);
  if (found != kinds.end()) return **found;
  std::vector<std::string_view> names;
  for (const Kind* one : kinds) names.push_back(one->name);
  file.fail("kind", fmt::format("unknown kind '{}'; the kinds are {}", kind, fmt::join(names, ", ")));
}

std::vector<FigureForm> make_forms(std::span<const FigureSchema> schema) {
  std::vector<FigureForm> forms;
  forms.reserve(schema.size());
  for (const FigureSchema& figure : schema)
    forms.push_back({figure.key, figure.unit, figure.least, figure.most, figure.names, figure.ideal, figure.priced});
  return forms;
}

Machine read_machine(const FigureFile& file, std::span<const Kind* const> kinds) {
  const Kind& kind = find_kind(file, kinds);
  Machine machine = blank_machine(kind);
  machine.name = file.text("name");
  machine.description = file.text("description");
  for (ReadFigure& read : file.figures(make_forms(kind.schema), machine_words)) {
    kind.schema[read.form].store(machine, read.value);
    machine.figures.push_back(std::move(read.figure));
  }
  try {
    complete(machine);
    set_picture_size(machine, machine.picture);
  } catch (const FigureError& error) {
    file.fail(error.key(), error.what());
  } catch (const InputError& error) {
    file.fail("picture", error.what());
  }
  return machine;
}

}  // namespace

Machine read_description(std::string_view text, std::string_view file, std::span<const Kind* const> kinds,
                         std::span<const std::string> changes) {
  return read_changed(text, file, changes, [&](const toml::table& root, const std::string& spec) {
    return read_machine(FigureFile(root, file, spec), kinds);
  });
}

}  // namespace csgsim::machines
