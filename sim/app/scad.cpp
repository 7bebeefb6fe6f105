#include "sim/app/scad.h"

#include <array>
#include <optional>
#include <sstream>

#include "hw/base/child_process.h"
#include "hw/base/error.h"
#include "hw/base/memory_file.h"
#include "hw/base/messages.h"
#include "hw/base/text.h"

namespace csgsim::app {

namespace {

/// A loop can complain thousands of times of the same thing: the first lines are passed on, the others counted.
void tell_warnings(const std::string& said, const std::string& file) {
  constexpr int most = 10;
  int count = 0;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("WARNING") && !line.starts_with("DEPRECATED")) continue;
    if (++count <= most) tell_line("openscad: " + line);
  }
  if (count > most) {
    tell_line("openscad: " + std::to_string(count - most) + " more warnings; for all of them: openscad -o model.csg " +
              shell_word(file));
  }
}

}  // namespace

std::string csg_of_scad(const std::string& file) {
  const std::string path = file.starts_with('-') ? "./" + file : file;
  const std::array<std::string, 6> words{"openscad", "-o", "-", "--export-format", "csg", path};
  const MemoryFile input(file);
  const MemoryFile output(file);
  const MemoryFile errors(file);
  const std::optional<int> status = run_child(words, {input, output, errors});
  if (!status) {
    throw InputError(printable(file) +
                     ": OpenSCAD's source has to be evaluated by OpenSCAD, which is not on the PATH; install it "
                     "(Debian: openscad), or export the model elsewhere: openscad -o model.csg model.scad");
  }
  if (*status != 0) throw InputError(printable(file) + ": " + printable(why_failed(*status, errors)));
  tell_warnings(errors.content(), file);
  std::string csg = output.content();
  if (csg.find_first_not_of(" \n\r\t") == csg.npos)
    throw InputError(printable(file) +
                     ": it makes no shape, so there is nothing to draw; call a module that makes one");
  return csg;
}

}  // namespace csgsim::app
