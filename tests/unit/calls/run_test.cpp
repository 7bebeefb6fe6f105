#include "sim/calls/run.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sim/shell/usage.h"

using namespace csgsim;

namespace {

namespace fs = std::filesystem;

/// A new folder, which is deleted with the object.
struct Folder {
  fs::path path;

  explicit Folder(const std::string& name)
      : path(fs::temp_directory_path() / (name + "-" + std::to_string(::getpid()))) {
    fs::create_directory(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return path / name; }
};

/// Options of a run that writes and reads each kind of file.
calls::RunProgramOptions options_in(const Folder& folder) {
  calls::RunProgramOptions options;
  options.program = folder.file("frame.csgt");
  options.machine = folder.file("machine.toml");
  options.run.picture = folder.file("picture.png");
  options.run.depth = folder.file("depth.png");
  options.run.owner = folder.file("owner.png");
  options.run.stats = folder.file("stats.json");
  for (const std::string* const file : {&options.program, &options.machine, &options.run.picture, &options.run.depth,
                                        &options.run.owner, &options.run.stats})
    std::ofstream(*file) << "content";
  return options;
}

/// What is said of a checkpoint; empty if it is allowed.
std::string refusal(calls::RunProgramOptions options, const std::string& checkpoint) {
  options.checkpoints.checkpoint = checkpoint;
  try {
    calls::refuse_misuse(options);
  } catch (const shell::UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a checkpoint replaces no file that the run reads or writes, each in turn") {
  const Folder folder("csgsim-calls");
  const calls::RunProgramOptions options = options_in(folder);
  for (const std::string& file : {options.program, options.machine, options.run.picture, options.run.depth,
                                  options.run.owner, options.run.stats}) {
    CAPTURE(file);
    CHECK(refusal(options, file).find(file) != std::string::npos);
    // Seen through a link, too.
    const std::string link = file + ".link";
    fs::create_symlink(file, link);
    CHECK_FALSE(refusal(options, link).empty());
  }
  CHECK(refusal(options, folder.file("run.checkpoint")).empty());
}

TEST_CASE("a file that the run does not name may become its checkpoint") {
  const Folder folder("csgsim-calls-free");
  calls::RunProgramOptions options = options_in(folder);
  for (std::string* const member : {&options.run.picture, &options.run.depth, &options.run.owner, &options.run.stats}) {
    const std::string file = *member;
    member->clear();
    CAPTURE(file);
    CHECK(refusal(options, file).empty());
    *member = file;
  }
}

TEST_CASE("the checkpoint that is resumed may be written again") {
  const Folder folder("csgsim-calls-resume");
  calls::RunProgramOptions options = options_in(folder);
  options.checkpoints.resume = folder.file("run.checkpoint");
  std::ofstream(options.checkpoints.resume) << "content";
  CHECK(refusal(options, options.checkpoints.resume).empty());
}

TEST_CASE("a run reads its Program, its machine's file and the checkpoint that it goes on from") {
  calls::RunProgramOptions options;
  options.program = "a.csgt";
  CHECK(options.files_read() == std::vector<fs::path>{"a.csgt"});
  options.machine = "b.toml";
  options.checkpoints.resume = "c.checkpoint";
  CHECK(options.inputs() == std::vector<fs::path>{"a.csgt", "b.toml"});
  CHECK(options.files_read() == std::vector<fs::path>{"a.csgt", "b.toml", "c.checkpoint"});
  options.machine = "pixel-planes-4";  // a name is no file
  CHECK(options.inputs() == std::vector<fs::path>{"a.csgt"});
}
