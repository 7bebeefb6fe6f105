#include "tests/cli/cli.h"
#include "tests/waves/vcd.h"

using namespace csgsim::testing::cli;

TEST_CASE("the commands for Surfer name each variable once and start with the pixels") {
  const Folder folder;
  require_success(
      run("wave " + model("old_example011") + " --size 16x16 --probe 8,8 --window 50:80 -o " + (folder / "w.vcd")));
  const csgsim::test::Vcd vcd(content(folder / "w.vcd"));
  std::vector<std::string> named;
  std::istringstream commands(content(folder / "w.sucl"));
  std::string last;
  for (std::string line; std::getline(commands, line); last = line) {
    if (line.starts_with("variable_add ")) named.push_back(line.substr(line.find(' ') + 1));
    if (line.starts_with("cursor_set ")) CHECK(line == "cursor_set 5100000");
  }
  CHECK(last == "goto_cursor");
  CHECK(named.at(1).starts_with("frame_buffer.pixel_8_8."));
  std::vector<std::string> all = vcd.names();
  std::erase(all, "frame_buffer.clock");
  std::ranges::sort(all);
  std::ranges::sort(named);
  CHECK(named == all);
}
