#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/base/output_file.h"
#include "hw/base/seconds.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/primitive_name.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"
#include "sim/waves/foreknowledge.h"
#include "sim/waves/record.h"
#include "sim/waves/view.h"
#include "sim/waves/wave_file.h"
#include "sim/waves/window.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelRequest model;
  std::vector<std::string> pixels;
  std::vector<std::string> probes;
  std::string window = "0:2000";
  std::uint32_t padding = 0;
  std::string at;
  std::string evaluator;
  bool whole = false;
  bool timing = false;
  bool lanes = false;
  std::string output;
};

wave::Pixel pixel_of(const std::string& text, const std::string& option, const isa::Program& program) {
  const Pixel pixel = parse_pixel(program, text, option);
  return {pixel.x, pixel.y};
}

/// Parses `tree.x:LEVEL` or `tree.y:LEVEL`.
wave::TreeLevel tree_level_of(const std::string& text) {
  using Axis = wave::TreeLevel::Axis;
  const bool is_x = text.rfind("tree.x:", 0) == 0;
  if (!is_x && text.rfind("tree.y:", 0) != 0)
    throw UsageError("--probe", fmt::format("'{}' is neither a pixel x,y nor a tree level such as tree.x:3", text));
  const auto level = numbers<unsigned>(text.substr(text.find(':') + 1), ',', 1, "--probe", "tree.x:LEVEL");
  return {is_x ? Axis::x : Axis::y, level.front()};
}

/// Whether the file holds the activities of the machine's units, as lanes.
bool has_lanes(const Options& options) { return options.lanes || has_extension(options.output, ".json"); }

/// Whether signals of pixels are recorded.
bool has_pixels(const Options& options) { return !options.pixels.empty() || !options.probes.empty(); }

/// Whether viewer files are written beside the waveform.
bool has_views(const Options& options) { return !is_unnamed_stream(options.output) && !has_lanes(options); }

waves::Format format_of(const Options& options) {
  if (!has_lanes(options)) return waves::Format::value_changes;
  return has_pixels(options) ? waves::Format::all_trace_events : waves::Format::trace_events;
}

/// The request without its windows and without the callback that writes the file.
wave::Request request_of(const Options& options, const isa::Program& program) {
  wave::Request request;
  for (const std::string& text : options.pixels) request.pixels.push_back(pixel_of(text, "--pixel", program));
  for (const std::string& text : options.probes) {
    if (text.find(',') != std::string::npos) {
      request.pixels.push_back(pixel_of(text, "--probe", program));
    } else {
      request.tree_levels.push_back(tree_level_of(text));
    }
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  std::erase_if(request.pixels, [&](wave::Pixel pixel) { return !seen.insert({pixel.x, pixel.y}).second; });
  if (request.pixels.empty() && (!has_lanes(options) || has_pixels(options)))
    throw UsageError("--pixel", "name a pixel to record, as in --pixel 100,20");
  return request;
}

/// The windows to record, and the clock of the marker.
struct Windows {
  std::vector<wave::Window> windows;
  std::uint64_t marked = 0;
  std::string shown;  ///< description for the summary
};

Windows windows_of(const Options& options, const std::optional<waves::WindowRequest>& requested,
                   const isa::Program& program, const machines::Machine& machine, const waves::Foreknowledge& known,
                   std::span<const wave::Pixel> pixels) {
  if (requested) {
    waves::WindowRequest request = *requested;
    if (request.kind == waves::WindowRequest::Kind::primitive)
      request.begin = parse_primitive(program, request.name, "--window");
    const auto windows =
        for_option("--window", [&] { return waves::find_windows(request, program, machine, known, pixels); });
    return {windows, windows.front().begin, fmt::format("{}", options.window)};
  }
  const waves::LastWrite last =
      for_option("--at", [&] { return waves::last_write(options.at, program, machine, known, pixels.front()); });
  return {last.windows, last.at_pixel.end - 1,
          fmt::format("i{}, the last write to {} of pixel {},{}, at clocks {}:{}", last.number, options.at,
                      pixels.front().x, pixels.front().y, last.at_pixel.begin, last.at_pixel.end)};
}

/// Prints the wall times, given in seconds, of the functional run, of the recording with its writing, and of the
/// writing alone.
void print_timing(double functional, double recording, double writing) {
  const double all = functional + recording - writing;
  fmt::print("functional run {:.1f} ms; with the window {:.1f} ms, {:.2f} times as long; writing {:.1f} ms more\n",
             functional * 1e3, all * 1e3, all / functional, writing * 1e3);
}

/// A window from clock 0 to the end of drawing or of scan-out, whichever is later.
Windows whole_frame(const waves::Foreknowledge& known) {
  return {{{0, std::max(known.result.clocks, known.result.shown_clocks)}}, 0, "the whole frame"};
}

/// Rejects options that need a pixel, where only unit activities are recorded.
void refuse_pixel_options(const OptionList& command) {
  for (const char* const option : {"at", "evaluator"}) {
    if (command.is_given(option))
      throw UsageError("--" + std::string(option), "needs a pixel; name one, as in --pixel 100,20");
  }
}

/// Rejects options that contradict each other. Returns the requested window, or nothing where --at replaces it.
std::optional<waves::WindowRequest> checked_window(const Options& options, const OptionList& command) {
  if (options.lanes && !is_unnamed_stream(options.output) && !has_extension(options.output, ".json"))
    throw UsageError("--lanes",
                     fmt::format("a file of lanes needs a name that ends in .json, not '{}'", options.output));
  if (!has_extension(options.output, ".vcd") && !has_extension(options.output, ".fst") && has_views(options))
    throw UsageError("--output", fmt::format("'{}' must end in .vcd or .fst for a waveform, or in .json for unit "
                                             "activities",
                                             options.output));
  const bool has_lanes_only = has_lanes(options) && !has_pixels(options);
  if (has_lanes_only) refuse_pixel_options(command);
  if (!is_model(options.model.model))
    refuse_model_options(command, {"machine", "set", "pixel", "probe", "window", "padding", "at", "evaluator", "whole",
                                   "timing", "lanes", "output"});
  if (!options.at.empty() && command.is_given("window"))
    throw UsageError("--at", "replaces --window; give only one of them");
  if (!options.at.empty()) return std::nullopt;
  const waves::WindowRequest requested = for_option("--window", [&] { return waves::parse_window(options.window); });
  if (has_lanes_only && requested.kind != waves::WindowRequest::Kind::clocks) {
    throw UsageError(
        "--window",
        "without a --pixel, unit activities are recorded over clocks FIRST:END; leave --window out for the "
        "whole frame");
  }
  return requested;
}

/// Paths of the viewer files.
std::vector<std::filesystem::path> view_paths(const Options& options) {
  std::vector<std::filesystem::path> paths;
  if (!has_views(options)) return paths;
  for (const waves::View& view : waves::views)
    paths.push_back(std::filesystem::path(options.output).replace_extension(view.ending));
  return paths;
}

void print_summary(const Options& options, const Windows& windows, const wave::Request& request,
                   std::uint64_t frame_clocks) {
  std::uint64_t clocks = 0;
  for (const wave::Window& window : request.windows) clocks += window.end - window.begin;
  if (has_lanes(options)) {
    fmt::print("{}: unit activities, {}, {} clocks; open it in ui.perfetto.dev\n", printable(options.output),
               windows.shown, grouped(clocks));
    return;
  }
  fmt::print("{}: {}; {} clocks of {} in {}, {}{}\n", printable(options.output), windows.shown, grouped(clocks),
             grouped(frame_clocks), count_text(request.windows.size(), "window"),
             count_text(request.pixels.size(), "pixel"),
             has_views(options) ? "; view it with gtkwave " + shell_word(view_paths(options).front().native()) : "");
}

void record(const Options& options, const OptionList& command) {
  const std::optional<waves::WindowRequest> requested = checked_window(options, command);
  std::vector<std::filesystem::path> outputs{options.output};
  for (std::filesystem::path& path : view_paths(options)) outputs.push_back(std::move(path));
  refuse_clashes(options.model.inputs(), outputs);
  std::deque<OutputFile> files;
  for (const std::filesystem::path& path : outputs) files.emplace_back(path);
  const ProgramOnMachine subject = program_of(options.model, command);
  const machines::Machine& machine = subject.machine;
  const isa::Program& program = subject.program;
  wave::Request request = request_of(options, program);
  const auto begin = std::chrono::steady_clock::now();
  const waves::Foreknowledge known =
      with_memory_for_run({&program, 1}, machine.array, [&] { return waves::gather_foreknowledge(program, machine); });
  const double functional_seconds = seconds_since(begin);
  refuse_overflow(known.result);
  const bool is_whole = has_lanes(options) && !command.is_given("window") && options.at.empty();
  const Windows windows =
      is_whole ? whole_frame(known) : windows_of(options, requested, program, machine, known, request.pixels);
  request.windows = waves::pad_windows(windows.windows, options.padding);
  waves::WaveFile waveform(files.front(), has_extension(options.output, ".fst"));
  request.write = [&](std::string_view text) { waveform.write(text); };
  const auto fidelity = options.whole ? waves::Fidelity::whole : waves::Fidelity::probed;
  const auto form =
      options.evaluator.empty() ? waves::evaluator_for(machine, request) : evaluator_form(options.evaluator);
  const waves::Recording recording = with_memory_for_run({&program, 1}, machine.array, [&] {
    return waves::record(program, machine, known, request, fidelity, form, format_of(options));
  });
  const double recording_seconds = seconds_since(begin) - functional_seconds;
  if (!recording.is_window_reached) {
    throw UsageError(
        "--window",
        fmt::format("the picture is drawn after {} clocks and shown after {}, before the window {} begins; choose an "
                    "earlier one",
                    known.result.clocks, known.result.shown_clocks, options.window));
  }
  waveform.finish();
  const waves::Shown shown{recording, request.windows, windows.marked, options.output, machine};
  std::vector<OutputFile*> whole{&files.front()};
  for (std::size_t i = 1; i < files.size(); ++i) {
    files[i].write(waves::views.at(i - 1).text(shown));
    whole.push_back(&files[i]);
  }
  commit_all(whole);
  print_summary(options, windows, request, known.result.clocks);
  if (options.timing) print_timing(functional_seconds, recording_seconds, recording.writing_seconds);
}

void add_wave(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "wave", run_group, "Record waveforms of a machine's units and of chosen pixels over a window of clocks",
      "Example:\n"
      "  csgsim wave traces/thesis_fig_2_3.csgt --pixel 200,300 --at owner -o last_write.vcd\n"
      "  csgsim wave traces/thesis_fig_2_3.csgt --pixel 200,300 --probe tree.x:3 --window i10:i14 -o trees.vcd\n"
      "  gtkwave trees.gtkw\n"
      "  csgsim wave traces/thesis_fig_2_3.csgt -o parts.json");
  options->model.add_to(command, "The model (.csg, .scad or .jan) or a Program (.csgt)");
  command.option("--pixel", options->pixels, "A pixel to record, x,y; repeat for several");
  command.option("--probe", options->probes,
                 "A pixel, as with --pixel, or a level of the multiplier trees that feed the pixels: tree.x:3");
  command.option(
      "--window", options->window,
      "Clocks FIRST:END, instructions iFIRST:iEND or iN, primitive:NAME, purpose:NAME or effect:NAME; END is "
      "exclusive");
  command.option("--padding", options->padding, "Extra clocks before and after each window");
  command.option("--at", options->at,
                 "Instead of --window: the instruction that last wrote owner, depth or FIELD of the first pixel");
  command
      .option("--evaluator", options->evaluator,
              "Multiplier trees of a frame buffer: worked-out from the coefficients, or stepped adder by adder; if not "
              "given, stepped where --probe names a tree level")
      .one_of(evaluator_names(), "evaluator");
  command.flag("--whole", options->whole,
               "Step the whole machine from the first clock, not only the probed pixels near the window");
  command.flag("--timing", options->timing, "Print the time taken, compared with the run at the functional level");
  command.flag("--lanes", options->lanes,
               "With -o -, write unit activities as JSON, as for a .json file, instead of VCD");
  command
      .option("-o,--output", options->output,
              "The waveform: .vcd, .fst (by vcd2fst), or - for VCD without a viewer file; .json: the unit activities "
              "over the frame, and with --pixel also the signals, as trace events for Perfetto")
      .required();
  command.add_quiet_option();
  command.set_action([options, &command] { record(*options, command); });
}

}  // namespace

extern const CommandRow wave_row{.name = "wave", .add = add_wave};

}  // namespace csgsim::app
