#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "hw/base/error.h"
#include "hw/base/inputs_kept.h"
#include "hw/base/messages.h"
#include "hw/base/partial_files.h"
#include "hw/base/standard_streams.h"
#include "sim/app/commands/commands.h"
#include "sim/app/study_commands.h"
#include "sim/session/options/usage.h"
#include "sim/studies/rows.h"

namespace {

constexpr int bad_input = 1;
constexpr int bad_usage = 2;
constexpr int our_fault = 3;

#ifdef CSGSIM_WITHOUT_CONVERT
constexpr bool has_convert = false;
#else
constexpr bool has_convert = true;
#endif

/// Throws InputError for a command that the CMake option CSGSIM_CONVERT left out of this build.
void refuse_left_out(std::span<char* const> arguments) {
  if (!has_convert && arguments.size() > 1 && std::string_view(arguments[1]) == "convert")
    throw csgsim::InputError("csgsim: this build lacks convert; build csgsim with -DCSGSIM_CONVERT=ON");
}

/// Whether all output reached standard output.
bool is_output_complete() {
  if (!csgsim::prints_to_standard_output()) return true;
  return std::cout.flush().good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

int report_incomplete_output() {
  csgsim::report_line("csgsim: cannot write to standard output; check for free space");
  return bad_input;
}

int run(csgsim::shell::CommandLine& line, std::span<char* const> arguments) {
  try {
    refuse_left_out(arguments);
    line.run(arguments);
  } catch (const csgsim::session::UsageError& error) {
    csgsim::report_line("csgsim: " + std::string(error.what()));
    return bad_usage;
  } catch (const csgsim::InputError& error) {
    csgsim::report_line(error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    csgsim::write_message("csgsim: there is not enough memory; use a smaller picture or model\n");
    return bad_input;
  } catch (const std::exception& error) {
    if (!is_output_complete()) return report_incomplete_output();
    csgsim::report_line("csgsim: " + std::string(error.what()) + "; this is a bug in csgsim, please report it");
    return our_fault;
  }
  return 0;
}

/// Whether the command line concerns one command only, so that the others need not be described: describing all of them
/// would need more time than converting a small model.
bool is_single_command(std::span<char* const> arguments) {
  const auto names_settings = [](std::string_view word) { return word.starts_with("--config"); };
  return std::ranges::none_of(arguments, names_settings);
}

/// Adds only the command or study of that name. Returns false if none has it, or if the command needs all others.
bool add_command(csgsim::shell::CommandLine& line, std::string_view name) {
  for (const csgsim::app::CommandRow* const row : csgsim::app::commands()) {
    if (row->name != name || row->needs_all_commands) continue;
    row->add(line);
    return true;
  }
  const auto studies = csgsim::studies::all();
  const auto found = std::ranges::find_if(studies, [&](const auto* row) { return row->name == name; });
  if (found == studies.end()) return false;
  csgsim::app::add_study_command(line, **found);
  return true;
}

void add_commands(csgsim::shell::CommandLine& line, std::span<char* const> arguments) {
  if (arguments.size() > 1 && is_single_command(arguments) && add_command(line, arguments[1])) return;
  for (const csgsim::app::CommandRow* const row : csgsim::app::commands()) row->add(line);
  for (const csgsim::studies::StudyRow* const row : csgsim::studies::all()) csgsim::app::add_study_command(line, *row);
  csgsim::app::add_gather_command(line, csgsim::studies::all());
}

}  // namespace

int main(int argc, char** argv) {
  csgsim::open_closed_standard_streams();
  csgsim::delete_partial_files_on_signals();
  csgsim::protect_inputs();
  csgsim::shell::CommandLine line(
      "csgsim: clock-accurate simulator of the logic-enhanced frame buffers of the 1980s that draw CSG models",
      "csgsim");
  line.add_own_options();
  const std::span<char* const> arguments(argv, static_cast<std::size_t>(argc));
  add_commands(line, arguments);
  const int code = run(line, arguments);
  return code == 0 && !is_output_complete() ? report_incomplete_output() : code;
}
