#include "host/lighting/colour_schemes.h"

#include <array>
#include <cstdint>

#include "host/lighting/lighting.h"

namespace csgsim::lighting {

namespace {

/// A colour in the notation of web pages.
constexpr glm::dvec3 rgb(std::uint32_t hex) {
  return {static_cast<double>(hex >> 16U) / 255.0, static_cast<double>((hex >> 8U) & 0xffU) / 255.0,
          static_cast<double>(hex & 0xffU) / 255.0};
}

constexpr auto schemes = std::to_array<ColourScheme>({
    {"Cornfield", background_colour, default_colour, default_cut_colour},
    {"Metallic", rgb(0xaaaaff), rgb(0xddddff), rgb(0xdd22dd)},
    {"Sunset", rgb(0xaa4444), rgb(0xffaaaa), rgb(0x882233)},
    {"Starnight", rgb(0x000000), rgb(0xffffe0), rgb(0x00ffff)},
    {"BeforeDawn", rgb(0x333333), rgb(0xcccccc), rgb(0x5563dd)},
    {"Nature", rgb(0xfafafa), rgb(0x16a085), rgb(0xdbf4da)},
    {"DeepOcean", rgb(0x333333), rgb(0xeeeeee), rgb(0x0babc8)},
    {"Solarized", rgb(0xfdf6e3), rgb(0xb58800), rgb(0x882233)},
    {"Tomorrow", rgb(0xf8f8f8), rgb(0x4271ae), rgb(0xf5871f)},
    {"Tomorrow Night", rgb(0x1d1f21), rgb(0x81a2be), rgb(0xde935f)},
    {"Monotone", rgb(0xffffe5), rgb(0xf9d72c), rgb(0xf9d72c)},
});

}  // namespace

std::span<const ColourScheme> colour_schemes() { return schemes; }

void apply(const ColourScheme& scheme, scene::Scene& scene) {
  scene.background.colour = scheme.background;
  scene.uncoloured = {scheme.face, scheme.cut_face};
}

}  // namespace csgsim::lighting
