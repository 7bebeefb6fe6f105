// Tests of the places of OpenSCAD's errors in an edited source, with a script in place of OpenSCAD.

#include <unistd.h>

#include "sim/viewer/session.h"
#include "tests/support/test.h"
#include "tests/unit/viewer/asked.h"

using namespace csgsim;
using viewer::Json;

namespace {

/// A folder that is first on the PATH.
struct Programs {
  fs::path folder = fs::temp_directory_path() / ("csgsim-scad-" + std::to_string(::getpid()));
  std::string before = std::getenv("PATH");

  Programs() {
    fs::create_directory(folder);
    ::setenv("PATH", (folder.native() + ":" + before).c_str(), 1);
  }
  ~Programs() {
    ::setenv("PATH", before.c_str(), 1);
    fs::remove_all(folder);
  }
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  /// An openscad that rejects its input with this message.
  void refuse_with(const std::string& message) const {
    const fs::path program = folder / "openscad";
    std::ofstream(program) << "#!/bin/sh\ncat >/dev/null\necho '" << message << "' >&2\nexit 1\n";
    fs::permissions(program, fs::perms::owner_all);
  }
};

}  // namespace

TEST_CASE("only an OpenSCAD error in the edited text has a line") {
  const Programs programs;
  const std::string model = programs.folder / "m.scad";
  std::ofstream(model) << "cube(1);\n";
  viewer::Session session({model, {}, Json::object()});
  const auto answer = [&](const std::string& message) {
    programs.refuse_with(message);
    const testing::Answer reply = testing::ask(session, "draw", {{"source", "cube(" + message}});
    CHECK(reply.status == 422);
    CHECK_FALSE(reply.json.contains("column"));
    return reply.json;
  };
  CHECK(answer("ERROR: Parser error in file <stdin>, line 3: syntax error")["line"] == 3);
  CHECK(answer("ERROR: Parser error in file <stdin>, line 120: syntax error")["line"] == 120);
  CHECK(answer("ERROR: Parser error in file <stdin>, line 9")["line"] == 9);
  CHECK_FALSE(answer("ERROR: Parser error in file <stdin>, line x").contains("line"));
  CHECK_FALSE(answer("ERROR: Parser error in file part.scad, line 4: syntax error").contains("line"));
}
