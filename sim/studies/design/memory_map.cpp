#include "sim/studies/design/memory_map.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

MemoryMap memory_map(const isa::Program& program) {
  MemoryMap map;
  for (const isa::NamedField& field : program.facts->fields) {
    const bool is_one_of_many = field.role == isa::FieldRole::stack || field.role == isa::FieldRole::stored;
    MemoryPart part{is_one_of_many ? std::string(isa::name_of(field.role)) : field.name, field.field.base,
                    field.field.width};
    const bool goes_on = is_one_of_many && !map.empty() && map.back().name == part.name &&
                         map.back().base + map.back().width == part.base;
    if (goes_on) {
      map.back().width += part.width;
    } else {
      map.push_back(std::move(part));
    }
  }
  return map;
}

std::string to_cell(const MemoryMap& map) {
  std::string cell;
  for (const MemoryPart& part : map) {
    cell += fmt::format("{}{}={}:{}", cell.empty() ? "" : " ", part.name, part.base, part.width);
  }
  return to_cell(cell);
}

void from_cell(const std::string& cell, MemoryMap& map) {
  map.clear();
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::size_t colon = word.find(':', equals);
    if (equals == std::string::npos || colon == std::string::npos)
      throw InputError("'" + word + "' is not of the form name=base:width");
    MemoryPart part{word.substr(0, equals), 0, 0};
    from_cell(word.substr(equals + 1, colon - equals - 1), part.base);
    from_cell(word.substr(colon + 1), part.width);
    map.push_back(std::move(part));
  }
}

void set_json(nlohmann::ordered_json& row, const char* name, const MemoryMap& map) {
  row[name] = nlohmann::ordered_json::array();
  for (const MemoryPart& part : map)
    row[name].push_back({{"name", part.name}, {"base", part.base}, {"width", part.width}});
}

}  // namespace csgsim::studies
