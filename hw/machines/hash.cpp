#include "hw/machines/hash.h"

#include <algorithm>
#include <vector>

#include "hw/base/hash.h"
#include "hw/machines/kind.h"

namespace csgsim::machines {

std::string hash_of(const Machine& machine) {
  std::vector<std::string> lines{std::string(machine.kind->name)};
  for (const Figure& figure : machine.figures) lines.push_back(figure.key + "=" + figure.value);
  std::sort(lines.begin(), lines.end());
  Hash hash;
  for (const std::string& line : lines) hash.add(line + "\n");
  return hash.text();
}

}  // namespace csgsim::machines
