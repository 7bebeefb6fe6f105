/// Every writable picture format under limits on the size of files: most writers do not report a file that could not
/// hold the picture.

#include <OpenImageIO/imageio.h>

#include "hw/base/output_file.h"
#include "hw/isa/facts.h"
#include "sim/observe/pictures.h"
#include "tests/cli/cli.h"
#include "tests/faults/child.h"

using namespace csgsim;

namespace {

using namespace csgsim::testing::faults;
using csgsim::testing::cli::content;
using csgsim::testing::cli::Folder;

constexpr const char* old_content = "an old picture\n";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string attribute(const char* name) { return OIIO::get_string_attribute(name); }

isa::Program program() {
  isa::Program program;
  program.shape = {16, 12, 48};
  program.colour = {20, 24};
  program.facts->fields = {{"Z2", {0, 20}, isa::FieldRole::depth}, {"colour", {20, 24}, isa::FieldRole::colour}};
  return program;
}

/// A picture of noise, which no format can compress much.
observe::Frame frame() {
  observe::Frame frame;
  frame.width = program().shape.width;
  frame.height = program().shape.height;
  std::uint32_t value = 1;
  for (std::uint32_t pixel = 0; pixel < frame.width * frame.height; ++pixel) {
    value = value * 1664525U + 1013904223U;
    frame.colour.push_back(value >> 8U);
    frame.depth.push_back(value >> 12U);
    frame.owner.push_back(value >> 28U);
  }
  return frame;
}

void write_picture(const std::string& path) {
  OutputFile file(path);
  observe::write_picture(file, frame(), program());
  file.commit();
}

/// Whether csgsim writes pictures with that ending; OpenImageIO lists more. Runs in a separate process, as does all
/// work that may start threads: a forked process would not have those threads.
bool is_written(const std::string& ending) {
  const Folder folder;
  return run_in_child([&] { write_picture(folder / ("p." + ending)); }, {}).code == 0;
}

/// File name endings such as "png", for each format that csgsim writes.
std::vector<std::vector<std::string>> endings() {
  const std::vector<std::string> written = split(attribute("output_format_list"), ',');
  std::vector<std::vector<std::string>> all;
  for (const std::string& format : split(attribute("extension_list"), ';')) {
    const std::vector<std::string> parts = split(format, ':');
    if (std::ranges::find(written, parts.at(0)) == written.end()) continue;
    std::vector<std::string> some = split(parts.at(1), ',');
    std::erase_if(some, [](const std::string& ending) { return !is_written(ending); });
    if (!some.empty()) all.push_back(std::move(some));
  }
  return all;
}

/// Limits of 0, 1, `between` values in between, and one byte less than the size.
std::set<std::uint64_t> limits_below(std::uint64_t size, std::uint64_t between) {
  std::set<std::uint64_t> limits{0, 1, size - 1};
  for (std::uint64_t i = 1; i <= between; ++i) limits.insert(size * i / (between + 1));
  return limits;
}

/// The size of a picture's file with that ending.
std::uint64_t size_of(const std::string& ending) {
  const Folder folder;
  const std::string path = folder / ("p." + ending);
  const ChildResult ended = run_in_child([&] { write_picture(path); }, {});
  CAPTURE(ended.err);
  REQUIRE(ended.code == 0);
  return fs::file_size(path);
}

/// Describes what is wrong after a failure; empty if nothing is.
std::string wrong_in(const Folder& folder, const std::string& path, const ChildResult& ended) {
  if (ended.signal != 0) return "ended by signal " + std::to_string(ended.signal);
  if (ended.code != 1) return "exit code " + std::to_string(ended.code);
  if (!csgsim::testing::cli::is_one_line(ended.err)) return "the error is not one line: " + ended.err;
  if (!ended.err.starts_with(path + ": ")) return "the error does not begin with the file: " + ended.err;
  if (content(path) != old_content) return "the old file has changed";
  return folder.files() == 1 ? "" : "there are files other than the picture";
}

}  // namespace

TEST_CASE("csgsim writes pictures with 17 common file name endings") {
  std::set<std::string> known;
  for (const std::vector<std::string>& format : endings()) known.insert(format.begin(), format.end());
  for (const std::string ending : {"png", "tif", "ppm", "exr", "jpg", "bmp", "tga", "gif", "jp2", "sgi", "hdr", "webp",
                                   "dpx", "fits", "ico", "iff", "rla"}) {
    CAPTURE(ending);
    CHECK(known.contains(ending));
  }
}

TEST_CASE("reports a picture too large for its file in any format and keeps the old one") {
  for (const std::vector<std::string>& format : endings()) {
    for (const std::string& ending : format) {
      const Folder folder;
      const std::string path = folder / ("p." + ending);
      CAPTURE(ending);
      // The same code writes all endings of a format.
      for (const std::uint64_t limit : limits_below(size_of(ending), ending == format.front() ? 11 : 1)) {
        CAPTURE(limit);
        csgsim::testing::cli::write(path, old_content);
        Conditions conditions;
        conditions.longest_file = limit;
        CHECK(wrong_in(folder, path, run_in_child([&] { write_picture(path); }, conditions)) == "");
      }
    }
  }
}

TEST_CASE("csgsim reports a picture too large for its file in any format") {
  const std::string model = csgsim::testing::cli::model("old_example011");
  for (const std::vector<std::string>& format : endings()) {
    const Folder folder;
    const std::string path = folder / ("p." + format.front());
    CAPTURE(path);
    csgsim::testing::cli::write(path, old_content);
    Conditions conditions;
    conditions.longest_file = 60;
    const ChildResult ended = run_csgsim({"render", model, "--size", "8x8", "-o", path}, conditions);
    CHECK(wrong_in(folder, path, ended) == "");
  }
}
