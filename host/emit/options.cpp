#include "host/emit/options.h"

#include <array>
#include <cstddef>

namespace csgsim::emit {

namespace {

constexpr std::array<std::string_view, strategies.size()> strategy_names{"stack",    "list",     "bits",
                                                                         "products", "parallel", "auto"};
constexpr std::array<std::string_view, colourings.size()> colouring_names{"rebroadcast", "field", "auto"};

}  // namespace

std::string_view name_of(Strategy strategy) { return strategy_names.at(static_cast<std::size_t>(strategy)); }
std::string_view name_of(Colouring colouring) { return colouring_names.at(static_cast<std::size_t>(colouring)); }

}  // namespace csgsim::emit
