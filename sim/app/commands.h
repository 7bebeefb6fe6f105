#pragma once

#include <CLI/CLI.hpp>

namespace csgsim::app {

/// Each adds one command to the command line; the command runs when the command line has been read.
void add_render(CLI::App& app);
void add_compile(CLI::App& app);
void add_run(CLI::App& app);
void add_disasm(CLI::App& app);
void add_wave(CLI::App& app);
void add_accuracy(CLI::App& app);
void add_sweep(CLI::App& app);
void add_compare(CLI::App& app);
void add_subdivide(CLI::App& app);
void add_levels(CLI::App& app);
void add_machines(CLI::App& app);
void add_isa(CLI::App& app);

}  // namespace csgsim::app
