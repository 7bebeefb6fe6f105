#include "sim/system/folder_lock.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "hw/base/error.h"

using namespace csgsim;

namespace {

namespace fs = std::filesystem;

class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "csgsim-base-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Scratch() { fs::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] auto files() const { return std::distance(fs::directory_iterator(path_), {}); }

 private:
  fs::path path_;
};

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a folder is kept for one process at a time, which the others are told") {
  const Scratch scratch;
  {
    const system::FolderLock lock(scratch.path(), "sweep");
    const std::string told = refusal([&] { system::FolderLock(scratch.path(), "compare"); });
    CHECK(contains(told, scratch.path().string()));
    CHECK(contains(told, "process " + std::to_string(::getpid()) + ", sweep"));
  }
  CHECK(scratch.files() == 0);
  CHECK(refusal([&] { system::FolderLock(scratch.path(), "compare"); }).empty());
}

TEST_CASE("the lock of a process that was killed keeps nobody out") {
  const Scratch scratch;
  std::array<int, 2> ready{};
  REQUIRE(::pipe(ready.data()) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const system::FolderLock lock(scratch.path(), "sweep");
    static_cast<void>(::write(ready[1], "x", 1));
    ::pause();
  }
  char byte = 0;
  REQUIRE(::read(ready[0], &byte, 1) == 1);
  CHECK(contains(refusal([&] { system::FolderLock(scratch.path(), "compare"); }), std::to_string(child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(scratch.files() == 1);
  CHECK(refusal([&] { system::FolderLock(scratch.path(), "compare"); }).empty());
  CHECK(scratch.files() == 0);
}
