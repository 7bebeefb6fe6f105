#include <unistd.h>

#include "host/read/read.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"

namespace {

/// A file or folder that the destructor deletes.
class Temporary {
 public:
  explicit Temporary(const std::string& name)
      : path_(fs::temp_directory_path() / fmt::format("csgsim-read-{}-{}", ::getpid(), name)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
  }

  void write(std::string_view text) const { std::ofstream(path_, std::ios::binary) << text; }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string error_of_file(const fs::path& path) {
  try {
    csgsim::read::read_csg_file(path);
  } catch (const csgsim::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a model file is read and named in the tree and in messages") {
  const Temporary file("good.csg");
  file.write("cube(1);\nsphere(r = 1);\n");
  const csgsim::model::Tree tree = csgsim::read::read_csg_file(file.path());
  CHECK(csgsim::read_test::outline(tree) == "union(cube, sphere)");
  CHECK(tree.file == file.path().string());
  file.write("cube(1);\nspere(r = 1);\n");
  CHECK(error_of_file(file.path()) == file.path().string() + ":2:1: unknown node spere(); did you mean sphere()?");
}

TEST_CASE("a missing or unreadable model file or a directory is reported in one line") {
  const Temporary missing("missing.csg");
  CHECK(error_of_file(missing.path()) ==
        missing.path().string() + ": cannot be read: No such file or directory; check the path and its permissions");
  const Temporary folder("folder.csg");
  fs::create_directory(folder.path());
  CHECK(error_of_file(folder.path()) == folder.path().string() + ": cannot be read: it is a folder; name a .csg file");
  const Temporary locked("locked.csg");
  locked.write("cube(1);");
  fs::permissions(locked.path(), fs::perms::none);
  if (::geteuid() != 0)
    CHECK(error_of_file(locked.path()) ==
          locked.path().string() + ": cannot be read: Permission denied; check the path and its permissions");
  CHECK(error_of_file("") == "the name of a file is empty; name the file");
}

TEST_CASE("a model file beyond 1 GiB is rejected without reading it") {
  const Temporary large("large.csg");
  large.write("cube(1);");
  fs::resize_file(large.path(), (std::uintmax_t{1} << 30U) + 1);
  CHECK(error_of_file(large.path()) == large.path().string() + ": longer than 1 GiB; split the model");
}

TEST_CASE("an empty model file is rejected") {
  const Temporary file("empty.csg");
  file.write("");
  CHECK(error_of_file(file.path()) == file.path().string() + ": no model found; export one from OpenSCAD");
}
