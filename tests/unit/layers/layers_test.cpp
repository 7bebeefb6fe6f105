#include <regex>

#include "places.h"
#include "tests/support/test.h"

namespace {

/// Sorted, one per line, so that a failed check shows the lines.
std::string lines_of(std::vector<std::string> found) {
  std::ranges::sort(found);
  std::string lines;
  for (const std::string& one : found) lines += one + "\n";
  return lines;
}

/// Lines `file: included` for files in a directory with an included path that has none of the allowed prefixes.
std::string foreign_includes(const std::string& folder, const std::vector<std::string>& allowed) {
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

TEST_CASE("hw/base includes nothing from other directories") { CHECK(foreign_includes("hw/base", {"hw/base/"}) == ""); }

TEST_CASE("hw includes neither host nor sim") { CHECK(foreign_includes("hw", {"hw/"}) == ""); }

TEST_CASE("the plain C++ parts of hw include no SystemC modules") {
  CHECK(foreign_includes("hw/array", {"hw/array/", "hw/base/", "hw/isa/", "hw/machines/"}) == "");
  CHECK(foreign_includes("hw/isa", {"hw/base/", "hw/isa/"}) == "");
  CHECK(foreign_includes("hw/machines", {"hw/base/", "hw/isa/", "hw/machines/"}) == "");
  CHECK(foreign_includes("hw/process", {"hw/base/", "hw/isa/", "hw/machines/", "hw/process/"}) == "");
  CHECK(foreign_includes("hw/processors", {"hw/base/", "hw/isa/", "hw/machines/", "hw/processors/"}) == "");
  CHECK(foreign_includes("hw/host", {"hw/base/", "hw/isa/", "hw/machines/", "hw/processors/", "hw/host/"}) == "");
}

TEST_CASE("the divider in plain C++ includes only the base and the instruction set") {
  CHECK(foreign_includes("hw/division", {"hw/division/", "hw/base/", "hw/isa/"}) == "");
}

TEST_CASE("host includes only the data formats of hw") {
  CHECK(foreign_includes("host", {"host/", "hw/base/", "hw/isa/", "hw/machines/", "hw/division/display_model.h",
                                  "hw/division/encoding.h", "hw/division/bit_stream.h", "hw/division/counts.h"}) == "");
}

TEST_CASE("host/convex includes neither the view nor the instruction set") {
  CHECK(foreign_includes("host/convex",
                         {"host/convex/", "host/csg/positive_tree.h", "host/facet/", "host/model/", "hw/base/"}) == "");
}

TEST_CASE("host/swept includes meshes as plain data but neither models nor machines") {
  CHECK(foreign_includes("host/swept", {"host/swept/", "host/solids/mesh.h", "hw/base/"}) == "");
}

TEST_CASE("sim/software includes the host but no machine model and no other part of sim") {
  CHECK(foreign_includes("sim/software", {"sim/software/", "host/", "hw/base/", "hw/machines/", "hw/processors/"}) ==
        "");
}

TEST_CASE("the three engines share no code except their interface and hw") {
  CHECK(foreign_includes("sim/reference",
                         {"sim/reference/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/", "hw/host/"}) == "");
  CHECK(foreign_includes("sim/functional",
                         {"sim/functional/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/", "hw/host/"}) == "");
  CHECK(foreign_includes("sim/cycle", {"sim/cycle/", "sim/engine/", "hw/"}) == "");
}

namespace {

/// A file of a machine kind that may use a Program, with the reason.
struct Exception {
  std::string file;
  std::string reason;
};

/// Whether the file describes a kind without building a machine, that is, contains no module.
bool is_description(const fs::path& file) {
  static const std::vector<std::string> stems{"kind", "timing", "account", "figures", "regions", "make"};
  const std::string stem = file.stem().string();
  return std::any_of(stems.begin(), stems.end(), [&](const std::string& one) { return stem.starts_with(one); });
}

/// Modules that use a Program, its segments or a host's instructions, as `directory/file`.
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

TEST_CASE("no module reads a Program except the listed files") {
  const std::vector<Exception> exceptions{
      {"bit_serial_memory/completion.cpp", "an observer: numbers of segments and instructions, for views"},
      {"bit_serial_memory/completion.h", "as above"},
      {"bit_serial_memory/memory_machine.cpp", "passes the Program to the host's end of the link"},
      {"bit_serial_memory/memory_machine.h", "as above"},
      {"bit_serial_memory/row_text.cpp", "a Program's row commands as text, which other simulators replay"},
      {"bit_serial_memory/row_text.h", "as above"},
      {"bit_serial_memory/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"bit_serial_memory/taps.h", "as above"},
      {"link/frame_words.cpp", "encodes a Program into the words of the host's memory"},
      {"link/frame_words.h", "as above"},
      {"multi_processor/clocks.cpp", "clocks of a list that a node holds or will receive"},
      {"multi_processor/clocks.h", "as above"},
      {"multi_processor/list_renderer.cpp", "the list that a node holds, as it came over the bus"},
      {"multi_processor/list_renderer.h", "as above"},
      {"multi_processor/multi_processor.cpp", "passes the Program to the model of the host"},
      {"multi_processor/multi_processor.h", "as above"},
      {"multi_processor/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"multi_processor/taps.h", "as above"},
      {"pixel_planes/completion.cpp", "an observer: numbers of segments and instructions, for views"},
      {"pixel_planes/completion.h", "as above"},
      {"pixel_planes/pixel_planes.cpp", "passes the Program to the host's end of the link"},
      {"pixel_planes/pixel_planes.h", "as above"},
      {"pixel_planes/probed.cpp", "computes where in a frame a machine of selected pixels begins, for waves"},
      {"pixel_planes/probed.h", "as above"},
      {"pixel_planes/taps.cpp", "an observer: names of instructions and fields, for waves"},
      {"pixel_planes/taps.h", "as above"},
      {"pixel_square/commands.cpp", "encodes a square's instructions, of the host or as the divider has made them"},
      {"pixel_square/commands.h", "as above"},
      {"pixel_square/graphics_processors.cpp", "divider.kind processors: they send squares from their own memories"},
      {"pixel_square/graphics_processors.h", "as above"},
      {"pixel_square/host_sender.cpp", "divider.kind host: the host sends squares from its own memory"},
      {"pixel_square/host_sender.h", "as above"},
      {"pixel_square/pixel_square.cpp", "passes the Program to the model of the host"},
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

TEST_CASE("no machine and no engine reads facts or origins of a Program") {
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

TEST_CASE("headers declare names only in the namespace of their directory") {
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
  // An instantiation is declared in the namespace of its template; SystemC finds the operators of a link word in its
  // namespace; the others are forward declarations of page parts.
  CHECK(lines_of(strange) ==
        "hw/isa/program.h: csgsim\n"
        "hw/link/frame_words.h: csgsim::isa\n"
        "sim/session/run/report_option.h: csgsim::report\n"
        "sim/studies/study.h: csgsim::report\n");
}
