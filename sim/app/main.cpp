#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/partial_files.h"
#include "sim/app/commands.h"
#include "sim/app/usage.h"

namespace {

constexpr int bad_input = 1;
constexpr int bad_usage = 2;
constexpr int our_fault = 3;

/// Has all that was printed arrived?
bool printed() { return std::cout.flush().good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

int not_printed() {
  csgsim::tell_line("csgsim: standard output cannot be written; is there room?");
  return bad_input;
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    csgsim::tell_line("csgsim: " + csgsim::app::explain(app, error, {argv, static_cast<std::size_t>(argc)}));
    return bad_usage;
  } catch (const csgsim::InputError& error) {
    csgsim::tell_line(error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    csgsim::tell("csgsim: there is not enough memory\n");
    return bad_input;
  } catch (const std::exception& error) {
    if (!printed()) return not_printed();
    csgsim::tell_line("csgsim: " + std::string(error.what()) + "; this is a fault of csgsim, please report it");
    return our_fault;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  csgsim::keep_standard_numbers();
  csgsim::delete_partial_files_on_signals();
  CLI::App app("csgsim: clock-accurate simulator of the logic-enhanced frame buffers of the 1980s, drawing CSG models",
               "csgsim");
  app.require_subcommand(1);
  app.set_version_flag("--version", "csgsim " CSGSIM_VERSION);
  csgsim::app::add_render(app);
  csgsim::app::add_compile(app);
  csgsim::app::add_run(app);
  csgsim::app::add_disasm(app);
  csgsim::app::add_wave(app);
  csgsim::app::add_accuracy(app);
  csgsim::app::add_sweep(app);
  csgsim::app::add_compare(app);
  csgsim::app::add_subdivide(app);
  csgsim::app::add_levels(app);
  csgsim::app::add_machines(app);
  csgsim::app::add_isa(app);
  const int code = run(app, argc, argv);
  return code == 0 && !printed() ? not_printed() : code;
}
