#include <regex>

#include "places.h"
#include "tests/support/test.h"

namespace {

/// In their order, a line each, so that a failed check says which.
std::string lines_of(std::vector<std::string> found) {
  std::ranges::sort(found);
  std::string lines;
  for (const std::string& one : found) lines += one + "\n";
  return lines;
}

/// Lines `file: included` below a folder whose included path matches none of the allowed prefixes.
std::string strangers(const std::string& folder, const std::vector<std::string>& allowed) {
  static const std::regex include("^\\s*#\\s*include\\s*\"([^\"]+)\".*");
  std::vector<std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      const std::string path = match[1];
      const bool fine = std::any_of(allowed.begin(), allowed.end(),
                                    [&](const std::string& prefix) { return path.starts_with(prefix); });
      if (!fine) found.push_back(entry.path().filename().string() + ": " + path);
    }
  }
  return lines_of(found);
}

}  // namespace

TEST_CASE("the base room includes nothing of the others") { CHECK(strangers("hw/base", {"hw/base/"}) == ""); }

TEST_CASE("hw includes neither host nor sim") { CHECK(strangers("hw", {"hw/"}) == ""); }

TEST_CASE("the array in plain C++ and the instruction set know nothing of SystemC's modules") {
  CHECK(strangers("hw/array", {"hw/array/", "hw/base/", "hw/isa/", "hw/machines/"}) == "");
  CHECK(strangers("hw/isa", {"hw/base/", "hw/isa/"}) == "");
  CHECK(strangers("hw/machines", {"hw/base/", "hw/isa/", "hw/machines/"}) == "");
  CHECK(strangers("hw/process", {"hw/base/", "hw/isa/", "hw/machines/", "hw/process/"}) == "");
  CHECK(strangers("hw/processors", {"hw/base/", "hw/isa/", "hw/machines/", "hw/processors/"}) == "");
  CHECK(strangers("hw/host", {"hw/base/", "hw/isa/", "hw/machines/", "hw/processors/", "hw/host/"}) == "");
}

TEST_CASE("the divider in plain C++ knows the base and the instruction set alone") {
  CHECK(strangers("hw/division", {"hw/division/", "hw/base/", "hw/isa/"}) == "");
}

TEST_CASE("host includes nothing of hw but the base, the instruction set, the machine descriptions and what it sends") {
  CHECK(strangers("host", {"host/", "hw/base/", "hw/isa/", "hw/machines/", "hw/division/display_model.h",
                           "hw/division/encoding.h", "hw/division/bit_stream.h", "hw/division/counts.h"}) == "");
}

TEST_CASE("convex pieces are geometry in model space: they know neither the view nor the instruction stream") {
  CHECK(strangers("host/convex",
                  {"host/convex/", "host/csg/positive_tree.h", "host/facet/", "host/model/", "hw/base/"}) == "");
}

TEST_CASE("swept surfaces are geometry: they know meshes as plain data, and nothing of models and machines") {
  CHECK(strangers("host/swept", {"host/swept/", "host/solids/mesh.h", "hw/base/"}) == "");
}

TEST_CASE("methods of software work on what the host has made: they know no machine and no other room of sim") {
  CHECK(strangers("sim/software", {"sim/software/", "host/", "hw/base/", "hw/machines/", "hw/processors/"}) == "");
}

TEST_CASE("the engines share no code: each includes only itself, the engine interface and hw") {
  CHECK(strangers("sim/reference",
                  {"sim/reference/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/", "hw/host/"}) == "");
  CHECK(strangers("sim/functional",
                  {"sim/functional/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/", "hw/host/"}) == "");
  CHECK(strangers("sim/cycle", {"sim/cycle/", "sim/engine/", "hw/"}) == "");
}

namespace {

/// A file of a kind's room that may name a Program, with the reason.
struct Exception {
  std::string file;
  std::string reason;
};

/// What is known of a kind without building a machine: no module.
bool is_description(const fs::path& file) {
  static const std::vector<std::string> stems{"kind", "timing", "account", "figures", "regions", "make"};
  const std::string stem = file.stem().string();
  return std::any_of(stems.begin(), stems.end(), [&](const std::string& one) { return stem.starts_with(one); });
}

/// Modules that name a Program, its segments or a host's instructions: `room/file`.
std::string readers_of_programs(const std::vector<std::string>& rooms) {
  static const std::regex of_a_program(
      R"(isa::Program\b|isa::Segment\b|\bsegments\b|\.facts\b|span<const isa::Instruction>)");
  std::vector<std::string> found;
  for (const std::string& room : rooms) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / "hw" / room)) {
      const fs::path& path = entry.path();
      if ((path.extension() != ".h" && path.extension() != ".cpp") || is_description(path)) continue;
      std::ifstream file(path);
      for (std::string line; std::getline(file, line);) {
        line = line.substr(0, line.find("//"));
        if (std::regex_search(line, of_a_program)) {
          found.push_back(room + "/" + path.filename().string());
          break;
        }
      }
    }
  }
  return lines_of(found);
}

}  // namespace

TEST_CASE("no module reads a Program: each acts on what came in through its ports") {
  const std::vector<Exception> exceptions{
      {"bit_serial_memory/completion.cpp", "an observer: numbers of segments and instructions, for who watches"},
      {"bit_serial_memory/completion.h", "as above"},
      {"bit_serial_memory/memory_machine.cpp", "hands the Program to the host's end of the link"},
      {"bit_serial_memory/memory_machine.h", "as above"},
      {"bit_serial_memory/row_text.cpp", "a Program's row commands as text, which other simulators replay"},
      {"bit_serial_memory/row_text.h", "as above"},
      {"bit_serial_memory/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"bit_serial_memory/taps.h", "as above"},
      {"link/frame_words.cpp", "encodes a Program into the words of the host's memory"},
      {"link/frame_words.h", "as above"},
      {"multi_processor/clocks.cpp", "clocks of a list that a node holds, or has yet to hold"},
      {"multi_processor/clocks.h", "as above"},
      {"multi_processor/list_renderer.cpp", "the list that a node holds, as it came over the bus"},
      {"multi_processor/list_renderer.h", "as above"},
      {"multi_processor/multi_processor.cpp", "hands the Program to what stands for the host"},
      {"multi_processor/multi_processor.h", "as above"},
      {"multi_processor/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"multi_processor/taps.h", "as above"},
      {"pixel_planes/completion.cpp", "an observer: numbers of segments and instructions, for who watches"},
      {"pixel_planes/completion.h", "as above"},
      {"pixel_planes/pixel_planes.cpp", "hands the Program to the host's end of the link"},
      {"pixel_planes/pixel_planes.h", "as above"},
      {"pixel_planes/probed.cpp", "works out where in a frame a machine of some pixels begins, for waves"},
      {"pixel_planes/probed.h", "as above"},
      {"pixel_planes/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"pixel_planes/taps.h", "as above"},
      {"pixel_square/commands.cpp", "encodes a square's instructions, of the host or as the divider has made them"},
      {"pixel_square/commands.h", "as above"},
      {"pixel_square/graphics_processors.cpp", "divider.kind processors: they send squares from their own memories"},
      {"pixel_square/graphics_processors.h", "as above"},
      {"pixel_square/host_sender.cpp", "divider.kind host: the host sends squares from its own memory"},
      {"pixel_square/host_sender.h", "as above"},
      {"pixel_square/pixel_square.cpp", "hands the Program to what stands for the host"},
      {"pixel_square/pixel_square.h", "as above"},
      {"pixel_square/renderer_taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"pixel_square/renderer_taps.h", "as above"},
      {"pixel_square/taps.cpp", "an observer: names of squares, for waves"},
      {"pixel_square/taps.h", "as above"},
      {"pixel_square/storage_check.cpp", "checks the Program before a run: what its division takes fits the divider"},
      {"pixel_square/storage_check.h", "as above"},
      {"scan_line/chain_link.cpp", "the host's end of a chain's link: the host's own memory"},
      {"scan_line/line_host.cpp", "the host, whose own memory the lines are in"},
      {"scan_line/picture_lines.h", "what the host's memory holds of a frame"},
      {"scan_line/scan_line_array.cpp", "hands the Program to the host"},
      {"scan_line/scan_line_array.h", "as above"},
      {"scan_line/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"scan_line/taps.h", "as above"},
      {"systemc/clocked_machine.cpp", "hands Programs to a machine"},
      {"systemc/clocked_machine.h", "as above"},
      {"systemc/segment_names.h", "an observer: which segment of the Program a region is"},
  };
  std::vector<std::string> allowed;
  for (const Exception& one : exceptions) allowed.push_back(one.file);
  CHECK(readers_of_programs({"array", "bit_serial_memory", "link", "multi_processor", "pixel_planes", "pixel_square",
                             "scan_line", "systemc"}) == lines_of(allowed));
}

TEST_CASE("no machine and no engine reads facts, which are for people, nor whom an instruction serves") {
  const std::regex for_people(R"(\.facts\b|\.origin\b|\bfield_of\()");
  for (const char* const room : {"hw/array", "hw/bit_serial_memory", "hw/kinds", "hw/link", "hw/machines",
                                 "hw/multi_processor", "hw/pixel_planes", "hw/pixel_square", "hw/scan_line",
                                 "hw/systemc", "sim/cycle", "sim/engine", "sim/functional", "sim/reference"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / room)) {
      CAPTURE(entry.path().string());
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
        CHECK_FALSE(std::regex_search(line.substr(0, line.find("//")), for_people));
    }
  }
}

TEST_CASE("what a room declares is in the namespace of its name, and what the base declares in csgsim itself") {
  const std::regex opened(R"(^namespace (csgsim[a-z_:]*) \{.*)");
  std::vector<std::string> strange;
  for (const char* const part : {"hw", "host", "sim"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / part)) {
      if (entry.path().extension() != ".h") continue;
      const fs::path file = fs::relative(entry.path(), CSGSIM_SOURCE_DIR);
      const std::string room = std::next(file.begin())->string();
      const std::string own = room == "base" ? "csgsim" : "csgsim::" + room;
      std::ifstream lines(entry.path());
      for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, opened)) continue;
        const std::string name = match[1];
        if (name != own && !name.starts_with(own + "::")) strange.push_back(file.string() + ": " + name);
      }
    }
  }
  // An instantiation is declared in the namespace of its template; SystemC looks for the operators of a word of a link
  // beside the word; the others name parts of a page beforehand.
  CHECK(lines_of(strange) ==
        "hw/isa/program.h: csgsim\n"
        "hw/link/frame_words.h: csgsim::isa\n"
        "sim/session/run/report_option.h: csgsim::report\n"
        "sim/studies/study.h: csgsim::report\n");
}
