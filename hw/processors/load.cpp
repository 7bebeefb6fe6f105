#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

#include "hw/machines/catalogue.h"
#include "hw/machines/host.h"
#include "hw/processors/built_in.h"
#include "hw/processors/processor.h"

namespace csgsim::processors {

namespace {

machines::Catalogue<Processor> catalogue() { return {"processor", built_in_processors(), read_processor}; }

}  // namespace

std::vector<std::string_view> processor_names() { return catalogue().names(); }

const Processor& built_in_processor(std::string_view name) {
  constexpr const auto& names = machines::processor_names;
  static std::array<std::once_flag, names.size()> once;
  static std::array<Processor, names.size()> read;
  const auto which = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  std::call_once(once.at(which), [&] { read[which] = load_processor(std::string(name)); });
  return read[which];
}

Processor load_processor(const std::string& spec) { return catalogue().load(spec); }

}  // namespace csgsim::processors
