#include "sim/app/terminal.h"

#include <histedit.h>

#include <cstdio>
#include <cwchar>
#include <string_view>
#include <utility>

#include "sim/debug/completion.h"

namespace csgsim::app {

namespace {

constexpr int history_lines = 1000;

}  // namespace

struct Terminal::Editor {
  Editor(std::string shown, std::vector<std::string> known) : prompt(std::move(shown)), words(std::move(known)) {
    HistEvent event{};
    history(lines, &event, H_SETSIZE, history_lines);
    el_set(line, EL_CLIENTDATA, this);
    el_set(line, EL_PROMPT, show_prompt);
    el_set(line, EL_EDITOR, "emacs");
    el_set(line, EL_HIST, history, lines);
    el_wset(line, EL_ADDFN, L"complete", L"Complete the word", complete_word);  // el_set would leak its copies of the
                                                                                // strings
    el_set(line, EL_BIND, "^I", "complete", nullptr);
  }
  ~Editor() {
    el_end(line);
    history_end(lines);
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  static Editor& of(EditLine* line) {
    void* data = nullptr;
    el_get(line, EL_CLIENTDATA, &data);
    return *static_cast<Editor*>(data);
  }

  static char* show_prompt(EditLine* line) { return of(line).prompt.data(); }

  static unsigned char complete_word(EditLine* line, wint_t /*key*/) {
    const LineInfo* const info = el_line(line);
    const std::string_view before(info->buffer, static_cast<std::size_t>(info->cursor - info->buffer));
    const debug::Completion completion = debug::complete(before, of(line).words);
    if (!completion.insert.empty()) return el_insertstr(line, completion.insert.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    if (completion.candidates.empty()) return CC_ERROR;
    std::fputs("\n", stdout);
    for (const std::string& word : completion.candidates) std::fprintf(stdout, "%s  ", word.c_str());
    std::fputs("\n", stdout);
    return CC_REDISPLAY;
  }

  std::string prompt;
  std::vector<std::string> words;
  History* lines = history_init();
  EditLine* line = el_init("csgsim", stdin, stdout, stderr);
};

Terminal::Terminal(std::string prompt, std::vector<std::string> words)
    : editor_(std::make_unique<Editor>(std::move(prompt), std::move(words))) {}

Terminal::~Terminal() = default;

std::optional<std::string> Terminal::read_line() {
  int length = 0;
  const char* const read = el_gets(editor_->line, &length);
  if (read == nullptr || length <= 0) return std::nullopt;
  std::string text(read, static_cast<std::size_t>(length));
  if (text.ends_with('\n')) text.pop_back();
  HistEvent event{};
  if (!text.empty()) history(editor_->lines, &event, H_ENTER, text.c_str());
  return text;
}

}  // namespace csgsim::app
