#include "hw/machines/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "hw/machines/built_in.h"
#include "hw/machines/description.h"

namespace csgsim::machines {

namespace {

constexpr InputKind machine_file{"a machine file, which ends in .toml", std::size_t{1} << 20U,
                                 "a machine is described in far less"};

}  // namespace

bool answers(const Machine& machine) { return machine.kind == Kind::frame_buffer && machine.has_global_or; }

Size picture_size(const Machine& machine) {
  return machine.kind == Kind::frame_buffer ? Size{machine.array.width, machine.array.height} : machine.picture;
}

void set_picture_size(Machine& machine, Size size) {
  machine.picture = size;
  if (machine.kind == Kind::frame_buffer) {
    machine.array.width = size.width;
    machine.array.height = size.height;
  }
  if (machine.kind == Kind::scan_line && size.width > machine.array.width) {
    throw InputError(
        fmt::format("a line of {} pixels is longer than the {} cells of {}; take a narrower picture, or a "
                    "machine file with more cells.count",
                    size.width, machine.array.width, machine.name));
  }
}

void adopt(Machine& machine, const isa::Program& program) {
  set_picture_size(machine, {program.shape.width, program.shape.height});
  machine.array.memory_bits = program.shape.memory_bits;
}

std::vector<std::string_view> built_in_names() {
  std::vector<std::string_view> names;
  for (const BuiltIn& machine : built_in()) names.push_back(machine.name);
  return names;
}

bool is_file(std::string_view name_or_file) { return name_or_file.ends_with(".toml"); }

Machine load(const std::string& name_or_file) {
  if (is_file(name_or_file)) return read_description(read_file(name_or_file, machine_file), name_or_file);
  const auto found = std::find_if(built_in().begin(), built_in().end(),
                                  [&name_or_file](const BuiltIn& machine) { return machine.name == name_or_file; });
  if (found == built_in().end())
    throw InputError(fmt::format("unknown machine '{}'; the nearest known is '{}', and a file's name ends in .toml",
                                 name_or_file, nearest(name_or_file, built_in_names())));
  return read_description(found->text, fmt::format("{}.toml", found->name));
}

}  // namespace csgsim::machines
