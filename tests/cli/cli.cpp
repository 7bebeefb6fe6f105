#include "tests/cli/cli.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "places.h"

namespace csgsim::testing::cli {

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

Outcome run(const std::string& words) {
  const Folder folder;
  const std::string command = std::string(CSGSIM_BINARY_DIR) + "/csgsim " + words + " >" + (folder / "out") + " 2>" +
                              (folder / "err") + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err")};
}

Outcome run_words(const std::vector<std::string>& words, const fs::path& working_folder) {
  return run_program(std::string(CSGSIM_BINARY_DIR) + "/csgsim", words, working_folder);
}

Outcome run_program(const std::string& program, const std::vector<std::string>& words, const fs::path& working_folder) {
  const Folder folder;
  const std::string out = folder / "out";
  const std::string err = folder / "err";
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const auto connect = [](const std::string& file, int flags, int number) {
      return ::dup2(::open(file.c_str(), flags, 0600), number) == number;
    };
    if (::chdir(working_folder.c_str()) == 0 && connect("/dev/null", O_RDONLY, STDIN_FILENO) &&
        connect(out, O_WRONLY | O_CREAT, STDOUT_FILENO) && connect(err, O_WRONLY | O_CREAT, STDERR_FILENO))
      ::execvp(arguments.front(), arguments.data());
    std::_Exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
}

void write_stand_in(const Folder& folder, const std::string& name, const std::string& shell_commands) {
  write(folder / name, "#!/bin/sh\n" + shell_commands + "\n");
  fs::permissions(folder / name, fs::perms::owner_all);
}

std::string path_argument(const Folder& folder) { return "PATH=" + folder.path().string() + ":/usr/bin:/bin"; }

Outcome run_with_stand_ins(const Folder& folder, const std::vector<std::string>& words) {
  std::vector<std::string> all{path_argument(folder), std::string(CSGSIM_BINARY_DIR) + "/csgsim"};
  all.insert(all.end(), words.begin(), words.end());
  return run_program("env", all, folder.path());
}

std::string model(const std::string& name) { return std::string(CSGSIM_SOURCE_DIR) + "/tests/models/" + name + ".csg"; }

nlohmann::json json(const std::string& path) { return nlohmann::json::parse(std::ifstream(path)); }

bool is_one_line(const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

Outcome require_success(Outcome outcome) {
  CAPTURE(outcome.err.substr(0, 400));
  REQUIRE(outcome.code == 0);
  return outcome;
}

void fails(const Outcome& outcome, int exit_code, const std::vector<std::string>& error_texts) {
  CAPTURE(outcome.err.substr(0, 400));
  CHECK(outcome.code == exit_code);
  CHECK(is_one_line(outcome.err));
  for (const std::string& text : error_texts) {
    CAPTURE(text);
    CHECK(outcome.err.find(text) != std::string::npos);
  }
}

void check_rejected(const std::string& path, const std::string& error_text) {
  const Folder folder;
  fails(run("render " + path + " --size 32x32 -o " + (folder / "p.png") + " --stats " + (folder / "s.json")), 1,
        {error_text});
  CHECK(folder.files() == 0);
}

void check_text_rejected(const std::string& csg, const std::string& error_text) {
  const Folder folder;
  write(folder / "m.csg", csg);
  check_rejected(folder / "m.csg", error_text);
}

void check_misuse(const std::string& words, const std::string& error_text) { fails(run(words), 2, {error_text}); }

}  // namespace csgsim::testing::cli
