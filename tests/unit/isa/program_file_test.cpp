#include "hw/isa/program_file.h"

#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using namespace test;

/// An empty directory for a test case.
class Scratch {
 public:
  explicit Scratch(const std::string& name) : path_(fs::path(CSGSIM_BINARY_DIR) / "scratch_isa" / name) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { fs::remove_all(path_); }

  [[nodiscard]] fs::path operator/(const std::string& file) const { return path_ / file; }
  [[nodiscard]] auto files() const { return std::distance(fs::directory_iterator(path_), {}); }

 private:
  fs::path path_;
};

TEST_CASE("a Program file is written in the requested form and read back from it") {
  const Scratch scratch("forms");
  for (const ProgramForm form : {ProgramForm::binary, ProgramForm::text}) {
    const fs::path path = scratch / "p.csgt";
    save_program(sample_program(), path, form);
    CHECK(load_program(path) == sample_program());
    std::string begin(4, ' ');
    std::ifstream(path, std::ios::binary).read(begin.data(), 4);
    CHECK((begin == "CSGT") == (form == ProgramForm::binary));
  }
  CHECK(scratch.files() == 1);
}

TEST_CASE("a Program that cannot be written leaves no partial file") {
  const Scratch scratch("unwritable");
  fs::create_directory(scratch / "p.csgt");
  fs::create_directory(scratch / "p.csgt" / "full");
  CHECK(contains(refusal([&] { save_program(sample_program(), scratch / "p.csgt"); }), "cannot be written"));
  CHECK(scratch.files() == 1);
  CHECK(contains(refusal([&] { save_program(sample_program(), scratch / "none/p.csgt"); }), "cannot be written"));
}

TEST_CASE("the error for an unreadable Program file names it") {
  const Scratch scratch("unreadable");
  const fs::path path = scratch / "p.csgt";
  CHECK(refusal([&] { load_program(path); }).starts_with(path.string() + ": cannot be read: No such file"));
  fs::create_directory(path);
  CHECK(contains(refusal([&] { load_program(path); }), "it is a folder; name a .csgt file"));
}

TEST_CASE("an error in a Program file begins with the file's name") {
  const Scratch scratch("errors");
  const fs::path path = scratch / "p.csgt";
  std::ofstream(path) << "CSGT";
  CHECK(refusal([&] { load_program(path); }).starts_with(path.string() + ": ends too soon"));
  std::ofstream(path) << "enable_all";
  CHECK(refusal([&] { load_program(path); }).starts_with(path.string() + ":1:1: "));
}

TEST_CASE("a Program file larger than 1 GiB is rejected") {
  const Scratch scratch("large");
  const fs::path path = scratch / "p.csgt";
  save_program(sample_program(), path);
  fs::resize_file(path, (std::uintmax_t{1} << 30U) + 1);
  CHECK(refusal([&] { load_program(path); }) ==
        path.string() + ": longer than 1 GiB; draw a smaller picture, or fewer primitives");
}

}  // namespace
