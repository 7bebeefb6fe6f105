#include "hw/base/output_folder.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/support/scratch.h"
#include "tests/support/test.h"

using namespace csgsim;
using testing::error_of;
using testing::Scratch;

namespace {

/// Changes the current directory for its lifetime.
class Within {
 public:
  explicit Within(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~Within() { fs::current_path(before_); }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;

 private:
  fs::path before_;
};

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

constexpr int count = 12;

/// Writes files with the same text, half of them in a subdirectory.
void write(const fs::path& folder, const std::string& text, int files = count) {
  OutputFolder output(folder);
  for (int i = 0; i < files; ++i) output.write((i % 2 == 0 ? "in/" : "") + std::to_string(i), text);
  output.commit();
}

std::string refusal(const fs::path& folder) {
  return error_of([&] { write(folder, "new"); });
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Distinct texts of the files in the directory.
std::set<std::string> texts_in(const fs::path& folder) {
  std::set<std::string> texts;
  for (int i = 0; i < count; ++i) texts.insert(content(folder / ((i % 2 == 0 ? "in/" : "") + std::to_string(i))));
  return texts;
}

}  // namespace

TEST_CASE("OutputFolder writes to new or empty folders and replaces its earlier output") {
  const Scratch scratch;
  fs::create_directory(scratch / "empty");
  for (const char* const name : {"new", "empty", "in/another", "slash/"}) {
    CAPTURE(name);
    const fs::path folder = scratch / name;
    write(folder, "old");
    CHECK(texts_in(folder) == std::set<std::string>{"old"});
    write(folder, "new");
    CHECK(texts_in(folder) == std::set<std::string>{"new"});
  }
  CHECK(scratch.files() == 4);
}

TEST_CASE("an output folder that is a symbolic link stays a link") {
  const Scratch scratch;
  fs::create_directory(scratch / "folder");
  fs::create_directory_symlink("folder", scratch / "link");
  for (const char* const text : {"old", "new"}) write(scratch / "link", text);
  CHECK(fs::is_symlink(scratch / "link"));
  CHECK(texts_in(scratch / "folder") == std::set<std::string>{"new"});
  CHECK(scratch.files() == 2);
}

TEST_CASE("an output folder with foreign files is rejected and unchanged") {
  const Scratch scratch;
  put(scratch / "d/Makefile", "mine");
  const std::string why = refusal(scratch / "d");
  CHECK(contains(why, (scratch / "d").native() + ": it contains files that csgsim did not write"));
  CHECK(contains(why, "name an empty folder or a new one"));
  CHECK(content(scratch / "d/Makefile") == "mine");
  put(scratch / "file", "mine");
  CHECK(contains(refusal(scratch / "file"), "it is not a folder"));
  CHECK(content(scratch / "file") == "mine");
  CHECK(scratch.files() == 2);
}

TEST_CASE("the current directory and its parents are rejected as output even if empty") {
  const Scratch scratch;
  fs::create_directories(scratch / "d/e");
  const Within within(scratch / "d/e");
  for (const char* const name : {".", "..", "./", "../e"}) {
    CAPTURE(name);
    CHECK(contains(refusal(name), "it contains the current folder"));
  }
  CHECK(refusal("f").empty());
  CHECK(refusal("../beside").empty());
}

TEST_CASE("an output folder with an edited file is rejected") {
  const Scratch scratch;
  write(scratch / "d", "old");
  put(scratch / "d/in/2", "edited");
  CHECK(contains(refusal(scratch / "d"), (scratch / "d/in/2").native() + ": it has been edited"));
  CHECK(content(scratch / "d/in/2") == "edited");
  CHECK(content(scratch / "d/1") == "old");
  CHECK(scratch.files() == 1);
}

TEST_CASE("rewriting an output folder deletes its outdated files and keeps foreign files") {
  const Scratch scratch;
  write(scratch / "d", "old");
  put(scratch / "d/made", "made");
  put(scratch / "d/in/made", "made");
  put(scratch / "d/out/deep/made", "made");
  fs::create_symlink("nowhere", scratch / "d/link");
  write(scratch / "d", "new", 4);
  for (const char* const name : {"made", "in/made", "out/deep/made"}) CHECK(content(scratch / "d" / name) == "made");
  CHECK(fs::is_symlink(scratch / "d/link"));
  CHECK(content(scratch / "d/3") == "new");
  CHECK_FALSE(fs::exists(scratch / "d/5"));
  CHECK(scratch.files() == 1);
}

TEST_CASE("an output folder that is not committed leaves no files") {
  const Scratch scratch;
  { OutputFolder(scratch / "d").write("in/1", "text"); }
  CHECK(scratch.files() == 0);
}

TEST_CASE("a killed process leaves either the old or the new output folder complete") {
  const Scratch scratch;
  write(scratch / "d", "a");
  for (int trial = 0; trial < 40; ++trial) {
    const ::pid_t child = ::fork();
    if (child == 0) {
      for (int i = 0;; ++i) write(scratch / "d", i % 2 == 0 ? "b" : "a");
    }
    std::this_thread::sleep_for(std::chrono::microseconds(1500 + 457 * trial));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    CHECK(texts_in(scratch / "d").size() == 1);
  }
}
