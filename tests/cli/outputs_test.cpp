#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "hw/base/address_sanitizer.h"
#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

TEST_CASE("render rejects an unknown format and a missing folder and leaves no file") {
  const Folder folder;
  const std::string options = "render " + model("old_example011") + " --size 16x16 ";
  CHECK(run(options + "-o " + (folder / "picture.xyz")).code == 2);
  CHECK(run(options + "-o " + (folder / "none/picture.png")).code == 1);
  CHECK(run(options + "--stats " + (folder / "none/s.json")).code == 1);
  CHECK(folder.files() == 0);
}

TEST_CASE("csgsim without its picture module writes PNG and names the missing package") {
  const Folder folder;
  fs::copy_file(CSGSIM_BINARY_DIR "/csgsim", folder / "csgsim");
  const auto draw = [&](const std::string& picture) {
    const Outcome outcome =
        run_program(folder / "csgsim",
                    {"render", fs::absolute(model("old_example011")), "--size", "16x16", "-o", picture}, folder.path());
    CAPTURE(outcome.err);
    if (outcome.code != 0) CHECK(is_one_line(outcome.err));
    return outcome;
  };
  const std::string needed = "p.tif: csgsim_pictures.so, the part of csgsim that writes this format, was not found";
  CHECK(draw("p.png").code == 0);
  const Outcome missing = draw("p.tif");
  CHECK(missing.code == 1);
  CHECK(missing.err.starts_with(needed));
  CHECK(missing.err.find("cmake --install") != std::string::npos);
  write(folder / "csgsim_pictures.so", "no library");
  const Outcome broken = draw("p.tif");
  CHECK(broken.code == 1);
  CHECK(broken.err.starts_with("p.tif: " + (folder / "csgsim_pictures.so") + ", the part of csgsim"));
  CHECK(broken.err.find("cmake --install") != std::string::npos);
  fs::copy_file(CSGSIM_BINARY_DIR "/csgsim_pictures.so", folder / "csgsim_pictures.so",
                fs::copy_options::overwrite_existing);
  CHECK(draw("p.tif").code == 0);
  CHECK(content(folder / "p.tif").starts_with("II*"));
}

TEST_CASE("an output that is a symbolic link stays a link to the written file") {
  const Folder folder;
  fs::create_directory(folder / "real");
  write(folder / "real/old.png", "old");
  fs::create_symlink("real/old.png", folder / "old.png");
  fs::create_symlink("real/new.json", folder / "new.json");
  require_success(run("render " + model("old_example011") + " --size 16x16 -o " + (folder / "old.png") + " --stats " +
                      (folder / "new.json")));
  CHECK(fs::is_symlink(folder / "old.png"));
  CHECK(fs::is_symlink(folder / "new.json"));
  CHECK(content(folder / "real/old.png").substr(1, 3) == "PNG");
  CHECK(json(folder / "real/new.json")["machine"]["width"] == 16);
  CHECK(folder.files() == 3);
}

TEST_CASE("writes the whole file into an output that is a pipe") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const std::string& words : {"render " + model("old_example011") + " --size 16x16 --stats ",
                                   "compile " + model("old_example011") + " --size 16x16 -o "}) {
    std::string received;
    std::thread reader([&] { received = content(folder / "pipe"); });
    const int code = run(words + (folder / "pipe")).code;
    if (code != 0) ::close(::open((folder / "pipe").c_str(), O_WRONLY | O_NONBLOCK));
    reader.join();
    CHECK(code == 0);
    CHECK(received.size() > 100);
  }
  CHECK(fs::is_fifo(folder / "pipe"));
  CHECK(folder.files() == 1);
}

TEST_CASE("writes an output to standard output without the summary") {
  const Outcome outcome =
      require_success(run("render " + model("old_example011") + " --size 16x16 --stats /dev/stdout"));
  CHECK(outcome.out.find("\"by_purpose\"") != std::string::npos);
  CHECK(nlohmann::json::accept(outcome.out));
  CHECK(outcome.err.find("\ndrawn ") != std::string::npos);
}

TEST_CASE("rejects a folder as output") {
  const Folder folder;
  fs::create_directory(folder / "d.png");
  const Outcome outcome = run("render " + model("old_example011") + " --size 16x16 -o " + (folder / "d.png"));
  CHECK(outcome.code == 1);
  CHECK(is_one_line(outcome.err));
  CHECK(folder.files() == 1);
}

TEST_CASE("reports impossible outputs before it simulates and leaves no file") {
  const Folder folder;
  const std::string wave = "wave " + model("old_example011") + " --size 16x16 --probe 1,1 -o ";
  const Outcome no_folder = run(wave + (folder / "none/w.vcd"));
  CHECK(no_folder.code == 1);
  CHECK(is_one_line(no_folder.err));
  const std::string render = "render " + model("old_example011") + " --size 16x16 ";
  CHECK(run(render + "-o " + (folder / "p.png") + " --stats " + (folder / "none/s.json")).code == 1);
  check_misuse(render + "--depth " + (folder / "z.png"), ".exr");
  check_misuse(render + "--owner " + (folder / "o.jpg"), ".exr");
  fs::create_directory(folder / "d");
  check_misuse(render + "-o " + (folder / "p.exr") + " --depth " + (folder / "d/../p.exr"), "same file");
  fs::remove(folder / "d");
  CHECK(folder.files() == 0);
}

TEST_CASE("reports a standard output that cannot be written") {
  if (!fs::exists("/dev/full")) return;
  const Folder folder;
  const std::string binary = std::string(CSGSIM_BINARY_DIR) + "/csgsim ";
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3.csgt";
  for (const std::string& words :
       {"disasm " + program, std::string("manual instructions"), std::string("manual machines all")}) {
    const int status = std::system((binary + words + " >/dev/full 2>" + (folder / "err")).c_str());
    CHECK(WEXITSTATUS(status) == 1);
    CHECK(is_one_line(content(folder / "err")));
  }
}

#if !CSGSIM_ADDRESS_SANITIZER  // it reserves more address space than the limit

namespace {

/// Both output streams of a command under a limit of address space; it must end with exit code 1.
std::string said_within(int kilobytes, const std::string& words) {
  const std::string command =
      "ulimit -v " + std::to_string(kilobytes) + "; " + CSGSIM_BINARY_DIR + "/csgsim " + words + " 2>&1";
  FILE* const pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text(1000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), pipe));
  CHECK(WEXITSTATUS(::pclose(pipe)) == 1);
  return text;
}

}  // namespace

TEST_CASE("the error for a picture that exceeds the memory states its size") {
  const Folder folder;
  const std::string text =
      said_within(600000, "render " + model("old_example011") + " --size 12000x11000 -o " + (folder / "p.png"));
  CHECK(text.starts_with("12000 x 11000 pixels at the functional level take about 3.7 GB of memory\n"));
  const std::string last = text.substr(text.find('\n') + 1);
  CHECK(is_one_line(last));
  CHECK(last.find("memory for a picture of 12000 x 11000") != std::string::npos);
  CHECK(folder.files() == 0);
}

TEST_CASE("the error for half-spaces that exceed the memory states their number") {
  const Folder folder;
  {
    // 10,000 disjoint spheres with 62 half-spaces each.
    std::ofstream file(folder / "many.csg");
    for (int i = 0; i < 10000; ++i) {
      file << "multmatrix([[1,0,0," << i % 100 << "],[0,1,0," << i / 100
           << "],[0,0,1,0],[0,0,0,1]]){sphere(r=0.4,$fn=12);}\n";
    }
  }
  const std::string text =
      said_within(150000, "render " + (folder / "many.csg") + " --size 64x64 -o " + (folder / "p.png"));
  CHECK(is_one_line(text));
  CHECK(text.find(" half-spaces of ") != std::string::npos);
  CHECK(text.find("picture") == std::string::npos);
  CHECK(folder.files() == 1);
}
#endif
