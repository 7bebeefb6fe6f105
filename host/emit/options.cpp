#include "host/emit/options.h"

#include <array>
#include <cstddef>

namespace csgsim::emit {

namespace {

constexpr auto strategy_names =
    std::to_array<std::string_view>({"stack", "list", "bits", "products", "parallel", "stored", "polygons", "auto"});
constexpr auto colouring_names = std::to_array<std::string_view>({"rebroadcast", "field", "auto"});
static_assert(strategy_names.size() == strategies.size() && colouring_names.size() == colourings.size());

}  // namespace

std::string_view name_of(Strategy strategy) { return strategy_names.at(static_cast<std::size_t>(strategy)); }
std::string_view name_of(Colouring colouring) { return colouring_names.at(static_cast<std::size_t>(colouring)); }

}  // namespace csgsim::emit
