#include "host/emit/options.h"

namespace csgsim::emit {

std::string_view name_of(Strategy strategy) {
  switch (strategy) {
    case Strategy::stack: return "stack";
    case Strategy::list: return "list";
    case Strategy::bits: return "bits";
    case Strategy::products: return "products";
    case Strategy::parallel: return "parallel";
    case Strategy::automatic: return "auto";
  }
  return {};
}

std::string_view name_of(Colouring colouring) {
  switch (colouring) {
    case Colouring::rebroadcast: return "rebroadcast";
    case Colouring::field: return "field";
    case Colouring::automatic: return "auto";
  }
  return {};
}

}  // namespace csgsim::emit
