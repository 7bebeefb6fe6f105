#include "hw/kinds/load.h"
#include "tests/cli/cli.h"
#include "tests/cli/help_lines.h"

using namespace csgsim::testing::cli;

namespace {

/// The shell completion scripts of csgsim, and a folder with two models.
class Shells {
 public:
  Shells() {
    require_success(run_words({"--describe", folder_.path().string()}));
    fs::create_directory(folder_ / "here");
    for (const std::string name : {"one.csg", "two.csg"}) write(folder_ / "here/" + name, "");
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_ / name; }

  /// Completions that bash offers for the last of these words.
  [[nodiscard]] std::vector<std::string> bash(const std::vector<std::string>& words) const {
    std::vector<std::string> command{
        "-c", "source \"$0\"; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _csgsim; printf '%s\\n' \"${COMPREPLY[@]}\"",
        file("csgsim.bash")};
    command.insert(command.end(), words.begin(), words.end());
    return offered("bash", command);
  }

  /// Completions that fish offers at the end of the line, without their descriptions.
  [[nodiscard]] std::vector<std::string> fish(const std::string& line) const {
    std::vector<std::string> lines =
        offered("fish", {"--no-config", "-c", "source '" + file("csgsim.fish") + "'; complete -C '" + line + "'"});
    for (std::string& one : lines) one = one.substr(0, one.find('\t'));
    return lines;
  }

  /// The arguments that csgsim receives after this text and a tab are typed at a terminal.
  [[nodiscard]] std::string zsh(const std::string& typed) const {
    // Zsh runs in a pseudo-terminal; csgsim is a function there that prints its arguments.
    constexpr const char* script = R"zsh(
      zmodload zsh/zpty
      zpty inner zsh -f -i
      zpty -w inner "unset zle_bracketed_paste; PS1=; fpath=($1 \$fpath); autoload -Uz compinit; compinit -D -u"
      zpty -w inner 'function csgsim() { print -r -- "<""<$*>"">" }; print rea""dy'
      local text= all=
      while [[ $all != *ready* ]] { zpty -r inner text || break; all+=$text }
      zpty -w -n inner $2$'\t\n'
      while [[ $all != *\<\<*\>\>* ]] { zpty -r inner text || break; all+=$text }
      print -r -- "${${all##*<<}%%>>*}"
      zpty -d inner
    )zsh";
    const Outcome outcome = run_program(
        "timeout", {"20", "zsh", "-f", "-c", script, "zsh", folder_.path().string(), typed}, folder_ / "here");
    std::string words = outcome.out;
    while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
    return words;
  }

 private:
  [[nodiscard]] std::vector<std::string> offered(const std::string& shell,
                                                 const std::vector<std::string>& words) const {
    const Outcome outcome = run_program(shell, words, folder_ / "here");
    CHECK(outcome.err == "");
    std::vector<std::string> lines = lines_of(outcome.out);
    std::erase(lines, "");
    std::ranges::sort(lines);
    return lines;
  }

  Folder folder_;
};

using Words = std::vector<std::string>;

std::vector<std::string> machines_that_begin(std::string_view begin) {
  std::vector<std::string> names;
  for (const std::string_view name : csgsim::kinds::built_in_names())
    if (name.starts_with(begin)) names.emplace_back(name);
  std::ranges::sort(names);
  return names;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

/// Every long name of an option in a command's help.
std::vector<std::string> long_names(const std::string& command) {
  std::vector<std::string> names;
  for (const std::string& head : option_heads(command)) {
    for (std::size_t at = head.find("--"); at != std::string::npos; at = head.find("--", at + 2))
      names.push_back(head.substr(at, head.find_first_of(" ,", at) - at));
  }
  return names;
}

}  // namespace

TEST_CASE("the shells accept the syntax of the completion files") {
  const Shells shells;
  require_success(run_program("bash", {"-n", shells.file("csgsim.bash")}));
  require_success(run_program("zsh", {"-n", shells.file("_csgsim")}));
  require_success(run_program("fish", {"-n", shells.file("csgsim.fish")}));
}

TEST_CASE("bash completes commands and options and their values") {
  const Shells shells;
  CHECK(shells.bash({"csgsim", "ren"}) == Words{"render"});
  CHECK(shells.bash({"csgsim", "--ver"}) == Words{"--version"});
  CHECK(shells.bash({"csgsim", "render", "--strat"}) == Words{"--strategy"});
  CHECK(shells.bash({"csgsim", "render", "--strategy", "st"}) == Words{"stack", "stored"});
  CHECK(shells.bash({"csgsim", "render", "--strategy", "=", "sta"}) == Words{"stack"});
  CHECK(shells.bash({"csgsim", "render", "one.csg", "--machine", "pixel-p"}) == machines_that_begin("pixel-p"));
  CHECK(shells.bash({"csgsim", "compare", "--machines", "scan-line,multi"}) == Words{"scan-line,multi-processor"});
  CHECK(shells.bash({"csgsim", "render", "--colour-scheme", "Tom"}) == Words{"Tomorrow", "Tomorrow Night"});
  CHECK(shells.bash({"csgsim", "render", ""}) == Words{"one.csg", "two.csg"});
  CHECK(shells.bash({"csgsim", "render", "-o", "o"}) == Words{"one.csg"});
  CHECK(shells.bash({"csgsim", "render", "--quiet", "t"}) == Words{"two.csg"});
  CHECK(shells.bash({"csgsim", "manual", "machines", "scan"}) == machines_that_begin("scan"));
  CHECK(shells.bash({"csgsim", "render", "--size", "o"}).empty());
  CHECK(shells.bash({"csgsim", "nothing", "o"}).empty());
}

TEST_CASE("fish completes commands and options and their values") {
  const Shells shells;
  CHECK(shells.fish("csgsim ren") == Words{"render"});
  CHECK(shells.fish("csgsim render --strat") == Words{"--strategy"});
  CHECK(shells.fish("csgsim render --strategy st") == Words{"stack", "stored"});
  CHECK(shells.fish("csgsim render --colour-scheme Tom") == Words{"Tomorrow", "Tomorrow Night"});
  CHECK(shells.fish("csgsim render one.csg --machine pixel-p") == machines_that_begin("pixel-p"));
  CHECK(shells.fish("csgsim render o") == Words{"one.csg"});
  CHECK(shells.fish("csgsim render -o tw") == Words{"two.csg"});
}

TEST_CASE("zsh completes commands and options and values before the tab") {
  const Shells shells;
  CHECK(shells.zsh("csgsim ren") == "render");
  CHECK(shells.zsh("csgsim render --strat") == "render --strategy");
  CHECK(shells.zsh("csgsim render --strategy=sta") == "render --strategy=stack");
  CHECK(shells.zsh("csgsim render one.csg --machine scan") == "render one.csg --machine scan-line");
  CHECK(shells.zsh("csgsim render --colour-scheme=Tomorrow\\ ") == "render --colour-scheme=Tomorrow Night");
  CHECK(shells.zsh("csgsim compare --machines multi") == "compare --machines multi-processor");
  CHECK(shells.zsh("csgsim render o") == "render one.csg");
  CHECK(shells.zsh("csgsim render -o tw") == "render -o two.csg");
}

TEST_CASE("completion covers every command and every option in its help") {
  const Shells shells;
  const std::string zsh = content(shells.file("_csgsim"));
  const std::vector<std::string> first = shells.bash({"csgsim", ""});
  for (const std::string& command : commands()) {
    CAPTURE(command);
    CHECK(has(first, command));
    CHECK(shells.fish("csgsim " + command) == shells.bash({"csgsim", command}));
    const std::vector<std::string> bash = shells.bash({"csgsim", command, "-"});
    const std::vector<std::string> fish = shells.fish("csgsim " + command + " --");
    const std::size_t begin = zsh.find("    " + command + ")\n");
    REQUIRE(begin != std::string::npos);
    const std::string zsh_case = zsh.substr(begin, zsh.find(";;", begin) - begin);
    for (const std::string& option : long_names(command)) {
      CAPTURE(option);
      CHECK(has(bash, option));
      CHECK(has(fish, option));
      CHECK(zsh_case.find(option) != std::string::npos);
    }
  }
}
