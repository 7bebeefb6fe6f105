#include "host/effects/rows.h"

#include <array>

#include "host/effects/equalise.h"
#include "host/effects/smooth.h"
#include "host/effects/textures.h"
#include "host/emit/flat_shading.h"

namespace csgsim::effects {

namespace {

constexpr std::array<const emit::Effect*, 4> rows{&emit::flat, &smooth, &textures, &equalise};

}  // namespace

std::span<const emit::Effect* const> all() { return rows; }

std::vector<scene::Section> sections() {
  std::vector<scene::Section> sections;
  sections.reserve(rows.size());
  for (const emit::Effect* const one : rows) sections.push_back(one->section);
  return sections;
}

}  // namespace csgsim::effects
