#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/machines/names.h"
#include "hw/processors/built_in.h"
#include "hw/processors/processor.h"

namespace csgsim::processors {

namespace {

constexpr InputKind processor_file{"a processor file, which ends in .toml", std::size_t{1} << 20U,
                                   "a processor is described in far less"};

const BuiltInProcessor* built_in_named(std::string_view name) {
  const auto found = std::ranges::find(built_in_processors(), name, &BuiltInProcessor::name);
  return found == built_in_processors().end() ? nullptr : &*found;
}

Processor read(const BuiltInProcessor& known, std::span<const std::string> changes) {
  return read_processor(known.text, fmt::format("{}.toml", known.name), changes);
}

Processor read_file_of(const std::string& file, std::span<const std::string> changes) {
  const std::string text = read_file(file, processor_file);
  Processor processor = read_processor(text, file, changes);
  const std::string name = changes.empty() ? processor.name : read_processor(text, file).name;
  if (const BuiltInProcessor* const known = built_in_named(name))
    processor.name = name + machines::name_of_edits(processor.figures, read(*known, {}).figures);
  return processor;
}

}  // namespace

std::vector<std::string_view> processor_names() {
  std::vector<std::string_view> names;
  for (const BuiltInProcessor& one : built_in_processors()) names.push_back(one.name);
  return names;
}

Processor load_processor(const std::string& said) {
  const std::string name(machines::base_of(said));
  const std::vector<std::string> changes = machines::changes_of(said);
  if (!machines::file_of(said).empty()) return read_file_of(name, changes);
  if (const BuiltInProcessor* const found = built_in_named(name)) return read(*found, changes);
  throw InputError(no_such("processor", name, processor_names()) + ", or a file, whose name ends in .toml");
}

}  // namespace csgsim::processors
