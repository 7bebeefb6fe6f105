#include "sim/system/folder_lock.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/scratch.h"
#include "tests/support/test.h"

using namespace csgsim;
using testing::error_of;
using testing::Scratch;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a folder is locked by one process at a time and others report the holder") {
  const Scratch scratch;
  {
    const system::FolderLock lock(scratch.path(), "sweep");
    const std::string message = error_of([&] { system::FolderLock(scratch.path(), "compare"); });
    CHECK(contains(message, scratch.path().string()));
    CHECK(contains(message, "process " + std::to_string(::getpid()) + ", sweep"));
  }
  CHECK(scratch.files() == 0);
  CHECK(error_of([&] { system::FolderLock(scratch.path(), "compare"); }).empty());
}

TEST_CASE("the lock of a killed process blocks no other process") {
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
  CHECK(contains(error_of([&] { system::FolderLock(scratch.path(), "compare"); }), std::to_string(child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(scratch.files() == 1);
  CHECK(error_of([&] { system::FolderLock(scratch.path(), "compare"); }).empty());
  CHECK(scratch.files() == 0);
}
