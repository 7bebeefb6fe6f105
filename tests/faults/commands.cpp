#include "tests/faults/commands.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::testing::faults {

namespace {

const std::string pictures = " -o OUT/p.png --depth OUT/d.exr --owner OUT/o.png --stats OUT/s.json";
const std::vector<std::string> picture_files{"p.png", "d.exr", "o.png", "o.json", "s.json"};
const std::string small_model = " SOURCE/tests/models/old_example011.csg --size 8x8";
const std::string trace = " SOURCE/traces/thesis_fig_2_3.csgt";

const std::string accuracy = "accuracy" + small_model + " --views 1 -o OUT --no-plots";
const std::string sweep = "sweep" + small_model + " --strategy stack,list,bits --stack-bits 3 --threads 1 -o OUT";
const std::string advise = "advise" + small_model +
                           " --z-bits 16 --fraction-bits 6 --colour-bits 24 --strategy stack,list,products"
                           " --max-wrong-pixels 64 --threads 1 -o OUT";
const std::string compare =
    "compare" + small_model + " --sides 4 --fragments 3 --machines pixel-planes-4,scan-line --threads 1 -o OUT";

std::vector<std::string> plots(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    files.push_back(name + ".png");
    files.push_back(name + ".svg");
  }
  return files;
}

std::vector<std::string> with_plots(const std::string& json, const std::vector<std::string>& names) {
  std::vector<std::string> files = plots(names);
  files.push_back(json);
  return files;
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"render", "render" + small_model + pictures, picture_files, "", 0, 8},
      {"render to standard output", "render" + small_model + " --quiet --stats /dev/stdout", {}, "", 0, 8},
      {"render with a page",
       "render" + small_model + " --report OUT/p.html --stats OUT/s.json",
       {"p.html", "s.json"},
       "",
       0,
       4},
      {"compile", "compile" + small_model + " -o OUT/p.csgt", {"p.csgt"}, "", 0, 8},
      {"run", "run" + trace + pictures, picture_files, "", 0, 2},
      {"run with checkpoints", "run" + trace + " --checkpoint OUT/c.csgs -o OUT/p.png", {"c.csgs", "p.png"}, "", 0, 2},
      {"disasm", "disasm" + trace + " -o OUT/p.txt", {"p.txt"}, "", 0, 8},
      {"convert",
       "convert SOURCE/tests/models/old_example011.csg -o OUT/m.stl --stats OUT/s.json",
       {"m.stl", "s.json"},
       "",
       0,
       8},
      {"explain", "explain" + trace + " --pixel 200,300 --json OUT/e.json", {"e.json"}, "", 0, 8},
      {"wave",
       "wave" + small_model + " --probe 1,1 --window 0:1000 -o OUT/w.vcd",
       {"w.vcd", "w.gtkw", "w.sucl"},
       "",
       0,
       8},
      {"subdivide",
       "subdivide" + small_model + " --subdivisions 0,1 --threads 1 -o OUT --no-plots",
       {"subdivide.json"},
       "subdivide.csv",
       0,
       4},
      {"accuracy", accuracy, {"accuracy.json"}, "accuracy.csv", 0, 3},
      {"accuracy going on", accuracy, {"accuracy.json"}, "accuracy.csv", 72, 8},
      {"advise", advise + " --no-plots", {"advise.json"}, "advise.csv", 0, 4},
      {"advise going on", advise + " --no-plots", {"advise.json"}, "advise.csv", 5, 8},
      {"advise with plot", advise, with_plots("advise.json", {"advise"}), "advise.csv", 6, 0},
      {"explore",
       "explore" + small_model + " --vary z-bits=12,16 --threads 1 -o OUT --no-plots",
       {"explore.json"},
       "explore.csv",
       0,
       4},
      {"sweep", sweep + " --no-plots", {"sweep.json"}, "sweep.csv", 0, 4},
      {"sweep going on", sweep + " --no-plots", {"sweep.json"}, "sweep.csv", 2, 8},
      {"sweep with plots", sweep,
       with_plots("sweep.json", {"old_example011_scan_conversions", "old_example011_clocks", "old_example011_bits",
                                 "old_example011_memory"}),
       "sweep.csv", 3, 0},
      {"compare", compare + " --no-plots", {"compare.json"}, "compare.csv", 0, 3},
      {"compare going on", compare + " --no-plots", {"compare.json"}, "compare.csv", 5, 8},
      {"compare with plots", compare, with_plots("compare.json", {"compare_machines", "compare_pixels"}), "compare.csv",
       6, 3},
  };
  return all;
}

const Command& command(const std::string& name) {
  const auto found = std::ranges::find_if(commands(), [&](const Command& one) { return one.name == name; });
  if (found == commands().end()) throw std::logic_error("no command " + name);
  return *found;
}

}  // namespace csgsim::testing::faults
