#include "sim/rtl/design.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "sim/rtl/board.h"
#include "sim/rtl/parameters.h"
#include "sim/rtl/program_memory.h"
#include "sim/rtl/template.h"
#include "sim/rtl/templates.h"

namespace csgsim::rtl {

namespace {

std::string number(std::uint64_t value) { return fmt::format("{}", value); }

std::uint32_t value_of(const std::vector<Parameter>& parameters, std::string_view name) {
  return std::ranges::find(parameters, name, &Parameter::name)->value;
}

/// The parameter lines of an instance, each with the key of the machine description it comes from.
std::string parameter_lines(const std::vector<Parameter>& parameters) {
  std::string lines;
  for (const Parameter& parameter : parameters) {
    const bool is_last = &parameter == &parameters.back();
    const std::string line = fmt::format("    .{}({}){}", parameter.name, parameter.value, is_last ? "" : ",");
    lines += parameter.figure.empty() ? line : fmt::format("{:<28}// {}", line, parameter.figure);
    if (!is_last) lines += '\n';
  }
  return lines;
}

void check_picture(const isa::Program& program) {
  if (program.colour.width > 0) return;
  throw InputError("the Program has no colours, so nothing would be scanned out; compile a model that draws a picture");
}

std::vector<Filling> make_fillings(const machines::Machine& machine, const isa::Program* program,
                                   const std::vector<Parameter>& parameters) {
  const std::uint32_t colour_bits = value_of(parameters, "COLOUR_BITS");
  const std::uint32_t scan_pixels = value_of(parameters, "SCAN_PIXELS");
  const std::array<unsigned, 3> channels = isa::channel_widths(colour_bits);
  std::vector<Filling> fillings{
      {"MACHINE", machine.name},
      {"PARAMETERS", parameter_lines(parameters)},
      {"WIDTH", number(machine.array.width)},
      {"HEIGHT", number(machine.array.height)},
      {"LINK", number(machine.link.width)},
      {"LATENCY", number(machine.link.latency)},
      {"WORD_CLOCKS", number(machine.link.word_clocks)},
      {"SCAN_PIXELS", number(scan_pixels)},
      {"VIDEO_BITS", number(colour_bits)},
      {"VIDEO_WIRES", number(std::uint64_t{colour_bits} * scan_pixels)},
      {"RED_BITS", number(channels[0])},
      {"GREEN_BITS", number(channels[1])},
      {"BLUE_BITS", number(channels[2])},
      {"FITS", std::string(template_text("fits.md"))},
  };
  add_board(fillings, {.colour_bits = colour_bits, .scan_pixels = scan_pixels, .has_line = program == nullptr});
  const auto add_filled = [&](std::string_view name, std::string_view text) {
    fillings.push_back({name, fill_template(template_text(text), fillings)});
  };
  add_filled("TARGETS", program != nullptr ? "picture_targets.mk" : "no_picture_targets.mk");
  add_filled("MACHINE_PORTS", "machine_ports.v");
  add_filled("PIXEL_PLANES", "machine_instance.v");
  return fillings;
}

}  // namespace

std::vector<DesignFile> design_files(const machines::Machine& machine, const isa::Program* program) {
  if (program != nullptr) check_picture(*program);
  const std::vector<Parameter> parameters = verilog_parameters(machine, program);
  std::vector<Filling> fillings = make_fillings(machine, program, parameters);
  std::vector<DesignFile> files;
  for (const EmbeddedFile& file : verilog_files())
    files.push_back({"rtl/" + std::string(file.name), std::string(file.text)});
  if (program != nullptr) {
    ProgramMemory memory = program_memory(*program, machine.link.width);
    fillings.push_back({"WORDS", number(memory.word_count)});
    fillings.push_back({"INSTRUCTIONS", number(memory.begin_count - 1)});
    files.push_back({"program.hex", std::move(memory.words)});
    files.push_back({"begins.hex", std::move(memory.begins)});
  }
  const auto add = [&](const std::string& path, std::string_view text) {
    files.push_back({path, fill_template(template_text(text), fillings)});
  };
  add("system.v", program != nullptr ? "system.v" : "bare_system.v");
  add("board.v", "board.v");
  for (const char* const name : {"hx8k.pcf", "up5k.pcf", "Makefile"}) add(name, name);
  add("README.md", program != nullptr ? "README.md" : "bare_README.md");
  if (program != nullptr) {
    for (const char* const name : {"testbench.v", "png.py", "beside.py"}) add(name, name);
  }
  return files;
}

}  // namespace csgsim::rtl
