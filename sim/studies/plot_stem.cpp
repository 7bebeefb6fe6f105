#include "sim/studies/plot_stem.h"

#include "hw/base/hash.h"

namespace csgsim::studies {

std::string plot_stem(const std::filesystem::path& model) {
  constexpr std::size_t longest = 100;
  std::string stem = model.stem().native();
  if (stem.size() <= longest) return stem;
  Hash hash;
  hash.add(stem);
  return stem.substr(0, longest) + "-" + hash.text();
}

}  // namespace csgsim::studies
