#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/machines/names.h"
#include "hw/process/built_in.h"
#include "hw/process/process.h"

namespace csgsim::process {

namespace {

constexpr InputKind process_file{"a process file, which ends in .toml", std::size_t{1} << 20U,
                                 "a process is described in far less"};

const BuiltInProcess* built_in_named(std::string_view name) {
  const auto found = std::ranges::find(built_in_processes(), name, &BuiltInProcess::name);
  return found == built_in_processes().end() ? nullptr : &*found;
}

Process read(const BuiltInProcess& known, std::span<const std::string> changes) {
  return read_process(known.text, fmt::format("{}.toml", known.name), changes);
}

Process read_file_of(const std::string& file, std::span<const std::string> changes) {
  const std::string text = read_file(file, process_file);
  Process process = read_process(text, file, changes);
  const std::string name = changes.empty() ? process.name : read_process(text, file).name;
  if (const BuiltInProcess* const known = built_in_named(name))
    process.name = name + machines::name_of_edits(process.figures, read(*known, {}).figures);
  return process;
}

}  // namespace

std::vector<std::string_view> process_names() {
  std::vector<std::string_view> names;
  for (const BuiltInProcess& one : built_in_processes()) names.push_back(one.name);
  return names;
}

Process load_process(const std::string& said) {
  const std::string name(machines::base_of(said));
  const std::vector<std::string> changes = machines::changes_of(said);
  if (!machines::file_of(said).empty()) return read_file_of(name, changes);
  if (const BuiltInProcess* const found = built_in_named(name)) return read(*found, changes);
  throw InputError(no_such("process", name, process_names()) + ", or a file, whose name ends in .toml");
}

}  // namespace csgsim::process
