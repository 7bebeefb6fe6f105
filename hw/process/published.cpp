#include "hw/process/published.h"

#include <array>

#include "hw/machines/area.h"
#include "hw/process/price.h"

namespace csgsim::process {

using machines::Machine;

namespace {

/// A quantity of a process and its value in the model, which may depend on a built-in machine.
struct Entry {
  std::string_view process;
  std::string_view machine;
  Quantity quantity;
  double (*model)(const Process& process, const Machine& machine);
};

/// Length of the gates of the process divided by that of a chip.
constexpr double same_length = 1;

/// mm² of a chip with that many transistors of logic, whose gates are `length` times as long as those of the process.
double chip_mm2(const Process& process, double transistors, double length) {
  return transistors * static_cast<double>(process.transistor_area) * 1e-12 * length * length * 100 /
         static_cast<double>(process.utilization);
}

/// Watts of static nMOS gates: three transistors make one.
double static_watts(const Process& process, double transistors) {
  return transistors / 3 * static_cast<double>(process.static_power) * 1e-12;
}

double clock_mhz(const Process& process, const Machine& machine) {
  return static_cast<double>(clock_of(machine, process)->hz) * 1e-6;
}

double pixel_transistors(const Process& process, const Machine& machine) {
  const auto family = static_cast<machines::LogicFamily>(process.family);
  return static_cast<double>(*machines::logic_transistors(machine, family)) +
         machine.array.memory_bits * static_cast<double>(process.cell_transistors);
}

double memory_percent(const Process& process, const Machine& machine) {
  const PixelArea pixel = *pixel_mm2(machine, process);
  return 100 * pixel.memory / (pixel.logic + pixel.memory);
}

double chip_transistors(double pixels, const Process& process, const Machine& machine) {
  return pixels * pixel_transistors(process, machine);
}

double pixels_mm2(double pixels, const Process& process, const Machine& machine) {
  const PixelArea pixel = *pixel_mm2(machine, process);
  return pixels * (pixel.logic + pixel.memory);
}

/// Watts of pixels that all work in every clock of the machine.
double pixels_watts(double pixels, const Process& process, const Machine& machine) {
  const auto processors = static_cast<std::uint64_t>(pixels);
  const machines::Resources all{processors, processors * machine.array.memory_bits};
  const double without = *frame_joules(machine, {}, {0, 1}, process);  // the controller is on another chip
  return *frame_joules(machine, all, {processors * machine.clock_hz, 1}, process) - without;
}

double quadratic_percent(const Process& process, const Machine& linear) {
  Machine quadratic = linear;
  quadratic.evaluator_degree = 2;
  return 100 * (pixel_transistors(process, quadratic) / pixel_transistors(process, linear) - 1);
}

constexpr std::string_view list = "github.com/egarpor/handy, cpus.txt: a list, secondary";
constexpr std::string_view graphics_list = "github.com/egarpor/handy, gpus.txt: a list, secondary";
constexpr std::string_view irregular = "processors have pads, buses and irregular wires, arrays of pixels few";
constexpr std::string_view unread = "not in the abstract of Poulton et al. 1985";
constexpr std::string_view unread_5 = "not in the abstract of Fuchs et al. 1989";

constexpr double chip_4 = 64;   ///< pixels of a chip of Pixel-planes 4
constexpr double chip_5 = 256;  ///< pixels of a chip of Pixel-planes 5

const auto entries = std::to_array<Entry>({
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-planes 4, clock, MHz", 10, Use::fitted, "memory.access", 0.01, "",
      "Fuchs et al. 1985; Goldfeather et al. 1986"},
     clock_mhz},
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-planes 4, memory's part of the chip, %", 200.0 / 3, Use::fitted, "memory.periphery", 0.01, "",
      "Poulton et al. 1985, abstract: about two thirds"},
     memory_percent},
    {"nmos-3um",
     "",
     {"Motorola 68000, 3.5 um, die, mm2", 44, Use::fitted, "transistor.area", 0.01, "", list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 68'000, 3.5 / 3); }},
    {"nmos-3um",
     "",
     {"Intel 8086, half of the maximum power, W", 0.85, Use::fitted, "gate.static_power", 0.01, "",
      "Intel 8086 data sheet: 340 mA at 5 V"},
     [](const Process& process, const Machine& /*machine*/) { return static_watts(process, 29'000); }},
    {"nmos-3um",
     "",
     {"Intel 8086, 3 um, die, mm2", 33, Use::predicted, "", 0.65, irregular, list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 29'000, same_length); }},
    {"nmos-3um",
     "",
     {"Intel 80186, 3 um, die, mm2", 60, Use::predicted, "", 0.65, irregular, list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 55'000, same_length); }},
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-Powers, transistors more than Pixel-planes 4, %", 35, Use::predicted, "", 0.35,
      "the paper says about, and does not list what it counts", "Goldfeather and Fuchs 1986"},
     quadratic_percent},
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-planes 4, transistors of 64 pixels", 0, Use::not_found, "", 0, "", unread},
     [](const Process& process, const Machine& machine) { return chip_transistors(chip_4, process, machine); }},
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-planes 4, area of 64 pixels, mm2", 0, Use::not_found, "", 0, "", unread},
     [](const Process& process, const Machine& machine) { return pixels_mm2(chip_4, process, machine); }},
    {"nmos-3um",
     "pixel-planes-4",
     {"Pixel-planes 4, power of 64 pixels, W", 0, Use::not_found, "", 0, "", unread},
     [](const Process& process, const Machine& machine) { return pixels_watts(chip_4, process, machine); }},
    {"cmos-1.6um",
     "pixel-planes-5",
     {"Pixel-planes 5, clock, MHz", 40, Use::fitted, "memory.access", 0.01, "", "Fuchs et al. 1989, abstract"},
     clock_mhz},
    {"cmos-1.6um",
     "",
     {"Intel 80386, 1.5 um, die, mm2", 104, Use::fitted, "transistor.area", 0.01, "", list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 275'000, 1.5 / 1.6); }},
    {"cmos-1.6um",
     "",
     {"DEC MultiTitan, 1.5 um, die, mm2", 61, Use::predicted, "", 0.25,
      "another maker, and another part of memory in the transistors", list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 180'000, 1.5 / 1.6); }},
    {"cmos-1.6um",
     "pixel-planes-5",
     {"Pixel-planes 5, transistors of 256 pixels", 0, Use::not_found, "", 0, "", unread_5},
     [](const Process& process, const Machine& machine) { return chip_transistors(chip_5, process, machine); }},
    {"cmos-1.6um",
     "pixel-planes-5",
     {"Pixel-planes 5, area of 256 pixels, mm2", 0, Use::not_found, "", 0, "", unread_5},
     [](const Process& process, const Machine& machine) { return pixels_mm2(chip_5, process, machine); }},
    {"cmos-1.6um",
     "pixel-planes-5",
     {"Pixel-planes 5, power of 256 pixels, W", 0, Use::not_found, "", 0, "", unread_5},
     [](const Process& process, const Machine& machine) { return pixels_watts(chip_5, process, machine); }},
    {"cmos-45nm",
     "",
     {"AMD RV870, 40 nm, die, mm2", 334, Use::predicted, "", 0.6,
      "static memory, denser than logic, is part of its transistors", graphics_list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 2'154e6, 40.0 / 45); }},
    {"cmos-45nm",
     "",
     {"NVIDIA GF100, 40 nm, die, mm2", 526, Use::predicted, "", 0.6,
      "static memory, denser than logic, is part of its transistors", graphics_list},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 3'200e6, 40.0 / 45); }},
    {"cmos-7nm",
     "",
     {"Apple A12, 7 nm, die, mm2", 83.27, Use::fitted, "transistor.area", 0.01, "",
      "6.9 billion transistors, widely reported"},
     [](const Process& process, const Machine& /*machine*/) { return chip_mm2(process, 6'900e6, same_length); }},
});

/// Whether `name` is that of the built-in process, perhaps with changes.
bool is_process(std::string_view name, std::string_view built_in) {
  return name.starts_with(built_in) && (name.size() == built_in.size() || name[built_in.size()] == '+');
}

}  // namespace

std::vector<Comparison> compare_published(const Process& process, const LoadMachine& load) {
  std::vector<Comparison> all;
  for (const Entry& entry : entries)
    if (is_process(process.name, entry.process))
      all.push_back({entry.quantity, entry.model(process, entry.machine.empty() ? Machine() : load(entry.machine))});
  return all;
}

}  // namespace csgsim::process
