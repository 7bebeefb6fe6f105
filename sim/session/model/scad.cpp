#include "sim/session/model/scad.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "host/read/limits.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/inputs_kept.h"
#include "sim/session/model/scad_messages.h"
#include "sim/system/child_process.h"
#include "sim/system/memory_file.h"

namespace csgsim::session {

namespace {

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
  const std::string why = system::failure_text(end, limits);
  return end.exceeded == system::Exceeded::nothing
             ? why
             : "OpenSCAD was stopped: " + why + "; " + std::string(fix_for(end.exceeded));
}

/// Throws InputError if OpenSCAD failed; prints its messages if it ended within its limits.
void require_success(const system::ChildEnd& end, const system::ChildLimits& limits, const std::string& file,
                     const ScadOptions& options) {
  const auto fail = [&] { throw InputError(file + ": " + reason_of(end, limits)); };
  if (end.exceeded != system::Exceeded::nothing) fail();
  print_scad_messages(end.errors, file);
  if (std::string error = scad_error(end.errors, file); !error.empty()) {
    // OpenSCAD reads these values after the last line of the file.
    if (!options.defines.empty() && error.find("Parser error") != error.npos) error += "; check the values of -D";
    throw InputError(error);
  }
  if (!system::has_succeeded(end)) fail();
}

/// Output of an OpenSCAD command line, given as words.
std::string run_openscad(std::span<const std::string> words, const system::MemoryFile& input, const std::string& file,
                         const ScadOptions& options) {
  const system::ChildLimits limits{.time = options.time_limit,
                                   .output = read::max_file_bytes,
                                   .errors = std::size_t{16} << 20U,
                                   .memory = std::size_t{8} << 30U};
  std::optional<system::ChildEnd> ended = system::run_child(words, input, limits);
  if (!ended) {
    throw InputError(file +
                     ": a .scad source needs OpenSCAD, which is not on the PATH; install it (Debian, Ubuntu: sudo apt "
                     "install openscad; Fedora: sudo dnf install openscad; Arch: sudo pacman -S openscad; others: "
                     "openscad.org), or export the model elsewhere: openscad -o model.csg model.scad");
  }
  require_success(*ended, limits, file, options);
  std::string csg = std::move(ended->output);
  if (csg.find_first_not_of(" \n\r\t") == csg.npos)
    throw InputError(file + ": it creates no shape, so there is nothing to draw; call a module that creates one");
  return csg;
}

/// The words of a command line that runs OpenSCAD on `input`; `first` are words that precede `openscad`.
std::vector<std::string> openscad_words(std::vector<std::string> first, const std::string& input,
                                        const ScadOptions& options) {
  first.insert(first.end(), {"openscad", "-o", "-", "--export-format", "csg"});
  for (const std::string& define : options.defines) first.insert(first.end(), {"-D", define});
  if (!options.parameters.empty()) {
    // OpenSCAD may run in another folder. The set's name is in the same word because it may begin with a dash.
    first.insert(first.end(), {"-p", std::filesystem::absolute(options.parameters).native()});
    first.push_back("-P" + options.parameter_set);
  }
  first.push_back(input);
  return first;
}

/// Records the file as an input. Throws InputError if it does not exist: OpenSCAD's own message lacks the reason.
void record_existing(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    static_cast<void>(read_regular_file(file, {"a .scad file", read::max_file_bytes, ""}));
  record_input(file);
}

}  // namespace

std::string evaluate_scad(const std::string& file, const std::optional<std::string>& replacement,
                          const ScadOptions& options) {
  if (!replacement) record_existing(file);
  const std::string folder = std::filesystem::path(file).parent_path().native();
  const std::vector<std::string> words =
      replacement ? openscad_words({"env", "--chdir=" + (folder.empty() ? "." : folder)}, "-", options)
                  : openscad_words({}, file.starts_with('-') ? "./" + file : file, options);
  system::MemoryFile input(file);
  if (replacement) input.write(*replacement);
  return run_openscad(words, input, file, options);
}

}  // namespace csgsim::session
