#include "sim/session/model/scad.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/read/limits.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/inputs_kept.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"
#include "sim/system/child_process.h"
#include "sim/system/memory_file.h"

namespace csgsim::session {

namespace {

/// Prints the first warnings and counts the rest, since a loop can repeat a warning thousands of times.
void print_warnings(const std::string& said, const std::string& file) {
  constexpr int most = 10;
  int count = 0;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("WARNING") && !line.starts_with("DEPRECATED")) continue;
    if (++count <= most) report_line("openscad: " + line);
  }
  if (count > most) {
    report_line("openscad: " + std::to_string(count - most) +
                " more warnings; to see them all, run openscad -o model.csg " + shell_word(file));
  }
}

std::string_view fix_for(system::Exceeded exceeded) {
  switch (exceeded) {
    case system::Exceeded::nothing: return "";
    case system::Exceeded::time: return "simplify the model, or allow more time with --openscad-time SECONDS";
    case system::Exceeded::output: return "split the model";
    case system::Exceeded::errors: return "move its echo() out of loops";
  }
  return "";
}

std::string reason_of(const system::ChildEnd& end, const system::ChildLimits& limits) {
  const std::string why = printable(system::why_failed(end, limits));
  return end.exceeded == system::Exceeded::nothing
             ? why
             : "OpenSCAD was stopped: " + why + "; " + std::string(fix_for(end.exceeded));
}

/// Output of an OpenSCAD command line, given as words.
std::string evaluated(std::span<const std::string> words, const system::MemoryFile& input, const std::string& file,
                      std::chrono::seconds time_limit) {
  const system::ChildLimits limits{.time = time_limit,
                                   .output = read::max_file_bytes,
                                   .errors = std::size_t{16} << 20U,
                                   .memory = std::size_t{8} << 30U};
  std::optional<system::ChildEnd> ended = system::run_child(words, input, limits);
  if (!ended) {
    throw InputError(printable(file) +
                     ": a .scad source needs OpenSCAD, which is not on the PATH; install it "
                     "(Debian: openscad), or export the model elsewhere: openscad -o model.csg model.scad");
  }
  if (!system::has_succeeded(*ended)) throw InputError(printable(file) + ": " + reason_of(*ended, limits));
  print_warnings(ended->errors, file);
  std::string csg = std::move(ended->output);
  if (csg.find_first_not_of(" \n\r\t") == csg.npos)
    throw InputError(printable(file) +
                     ": it creates no shape, so there is nothing to draw; call a module that creates one");
  return csg;
}

}  // namespace

std::string evaluate_scad(const std::string& file, std::chrono::seconds time_limit) {
  // OpenSCAD's own message does not say why the file cannot be opened.
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    static_cast<void>(read_regular_file(file, {"a .scad file", read::max_file_bytes, ""}));
  const std::string path = file.starts_with('-') ? "./" + file : file;
  record_input(file);
  return evaluated(std::array<std::string, 6>{"openscad", "-o", "-", "--export-format", "csg", path},
                   system::MemoryFile(file), file, time_limit);
}

std::string evaluate_scad(const std::string& file, std::string_view text, std::chrono::seconds time_limit) {
  std::string folder = std::filesystem::path(file).parent_path().native();
  if (folder.empty()) folder = ".";
  system::MemoryFile input(file);
  input.write(text);
  return evaluated(
      std::array<std::string, 8>{"env", "--chdir=" + folder, "openscad", "-o", "-", "--export-format", "csg", "-"},
      input, file, time_limit);
}

}  // namespace csgsim::session
