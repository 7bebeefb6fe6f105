#include "sim/software/methods/rows.h"

#include <algorithm>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

std::vector<std::string> halving_directories() {
  std::vector<std::string> names;
  for (const DirectoryRow* const row : directories()) {
    if (row->halves_space) names.emplace_back(row->name);
  }
  return names;
}

const DirectoryRow& directory_of(const std::string& name) {
  const std::vector<std::string> names = row_names(directories());
  const auto place = std::ranges::find(names, name);
  if (place == names.end()) throw InputError(unknown_name_text("directory", name, names));
  return *directories()[static_cast<std::size_t>(place - names.begin())];
}

}  // namespace csgsim::software
