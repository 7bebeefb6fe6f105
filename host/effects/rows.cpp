#include "host/effects/rows.h"

#include <array>

#include "host/effects/mirrors.h"
#include "host/effects/smooth.h"
#include "host/effects/transparency.h"
#include "host/emit/flat_shading.h"

namespace csgsim::effects {

namespace {

// Mirrors before transparency: they are behind the glass.
constexpr std::array rows{&emit::flat, &smooth, &mirrors, &transparency};

}  // namespace

std::span<const emit::Effect* const> all() { return rows; }

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(rows.size());
  for (const emit::Effect* const one : rows) sections.push_back(one->section);
  return sections;
}

}  // namespace csgsim::effects
