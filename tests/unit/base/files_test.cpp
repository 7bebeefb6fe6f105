#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hw/base/file_roles.h"
#include "hw/base/input_file.h"
#include "hw/base/output_file.h"
#include "tests/support/scratch.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace testing;

namespace {

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool clash(std::initializer_list<fs::path> inputs, std::initializer_list<fs::path> outputs) {
  return find_clash(std::span(inputs.begin(), inputs.size()), std::span(outputs.begin(), outputs.size())).has_value();
}

constexpr InputKind small_file{"a small file", 1U << 10U, "cut it"};

}  // namespace

TEST_CASE("rejects a file longer than its limit even if its size is unknown") {
  const Scratch scratch;
  write_file(scratch / "fits", std::string(1024, 'x'));
  write_file(scratch / "long", std::string(1025, 'x'));
  CHECK(read_file(scratch / "fits", small_file).size() == 1024);
  CHECK(contains(error_of([&] { read_file(scratch / "long", small_file); }), "longer than 1 KiB; cut it"));
  CHECK(contains(error_of([&] { read_file("/dev/zero", small_file); }), "/dev/zero: longer than 1 KiB; cut it"));
  CHECK(read_file("/dev/null", small_file).empty());
  constexpr InputKind any_file{"a file", std::numeric_limits<std::size_t>::max(), ""};
  CHECK(read_file(scratch / "fits", any_file).size() == 1024);
}

TEST_CASE("a committed file replaces the old one atomically and keeps its permissions") {
  const Scratch scratch;
  write_file(scratch / "a", "old");
  fs::permissions(scratch / "a", fs::perms::owner_read | fs::perms::owner_write);
  {
    OutputFile file(scratch / "a");
    file.write("new, ");
    CHECK(content(scratch / "a") == "old");
    file.write("whole");
    file.commit();
    CHECK(content(scratch / "a") == "new, whole");
    CHECK(fs::status(scratch / "a").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  }
  { OutputFile(scratch / "a").write("dropped"); }
  CHECK(content(scratch / "a") == "new, whole");
  CHECK(scratch.files() == 1);
}

TEST_CASE("rejects impossible file names before anything is written") {
  const Scratch scratch;
  CHECK(contains(error_of([&] { OutputFile{""}; }), "empty name"));
  CHECK(contains(error_of([&] { OutputFile{scratch / std::string(256, 'n')}; }), "too long"));
  CHECK(contains(error_of([&] { OutputFile{scratch.path()}; }), "it is a folder"));
  CHECK(contains(error_of([&] { OutputFile{scratch / "none/a"}; }), "does not exist; create it first"));
  CHECK(contains(error_of([&] { OutputFile{scratch / std::string("a\0b", 3)}; }), "zero byte"));
  CHECK(contains(error_of([&] { read_file(scratch / std::string("a\0b", 3), {"a file", 9, ""}); }), "zero byte"));
  CHECK(error_of([&] { OutputFile{scratch / std::string(255, 'n')}; }).empty());
  CHECK(scratch.files() == 0);
}

TEST_CASE("rejects a read-only output file even if its directory is writable") {
  const Scratch scratch;
  write_file(scratch / "a", "kept");
  fs::permissions(scratch / "a", fs::perms::owner_read | fs::perms::others_read);
  fs::permissions(scratch.path(), fs::perms::all);
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(2);
    ::_exit(contains(error_of([&] { OutputFile{scratch / "a"}; }), "Permission denied") ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(content(scratch / "a") == "kept");
}

TEST_CASE("rejects an output that is the same file as an input or another output") {
  const Scratch scratch;
  const fs::path model = scratch / "m.csg";
  write_file(model, "cube();");
  fs::create_symlink("m.csg", scratch / "link");
  fs::create_hard_link(model, scratch / "hard");
  fs::create_directory(scratch / "d");
  fs::create_symlink("nowhere", scratch / "dangling");
  for (const char* other : {"m.csg", "./m.csg", "d/../m.csg", "link", "hard"}) {
    CAPTURE(other);
    CHECK(clash({model}, {scratch / other}));
  }
  CHECK_FALSE(clash({model}, {scratch / "new"}));
  CHECK(clash({}, {scratch / "new", scratch / "d/../new"}));
  CHECK(clash({}, {scratch / "dangling", scratch / "nowhere"}));
  CHECK(clash({}, {scratch / "link", scratch / "hard"}));
  CHECK_FALSE(clash({}, {scratch / "new", scratch / "d/new"}));
  CHECK_FALSE(clash({}, {"/dev/null", "/dev/null"}));
  CHECK_FALSE(clash({model}, {scratch / "none/m.csg"}));
}
