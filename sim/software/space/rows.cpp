#include "sim/software/methods/rows.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

extern const DirectoryRow excell_row;
extern const DirectoryRow recursive_excell_row;
extern const DirectoryRow octree_row;
extern const DirectoryRow grid_row;
extern const DirectoryRow kd_tree_row;
extern const DirectoryRow bvh_row;
extern const DirectoryRow boxes_row;
extern const DirectoryRow none_row;

namespace {

constexpr std::array directory_rows{&excell_row, &recursive_excell_row, &boxes_row, &octree_row,
                                    &grid_row,   &kd_tree_row,          &bvh_row,   &none_row};

}  // namespace

std::span<const DirectoryRow* const> directories() { return directory_rows; }

std::vector<std::string> halving_directories() {
  std::vector<std::string> names;
  for (const DirectoryRow* const row : directory_rows) {
    if (row->halves_space) names.emplace_back(row->name);
  }
  return names;
}

const DirectoryRow& directory_of(const std::string& name) {
  const std::vector<std::string> names = names_in(directory_rows);
  const auto place = std::ranges::find(names, name);
  if (place == names.end()) throw InputError(no_such("directory", name, names));
  return *directory_rows[static_cast<std::size_t>(place - names.begin())];
}

}  // namespace csgsim::software
