#include "hw/base/child_process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace csgsim {

namespace {

class Actions {
 public:
  Actions() { ::posix_spawn_file_actions_init(&actions_); }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  void connect(const MemoryFile& file, int number) {
    ::posix_spawn_file_actions_adddup2(&actions_, file.descriptor().number(), number);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::optional<int> run_child(std::span<const std::string> words, const ChildFiles& files) {
  Actions actions;
  actions.connect(files.input, STDIN_FILENO);
  actions.connect(files.output, STDOUT_FILENO);
  actions.connect(files.errors, STDERR_FILENO);
  std::vector<std::string> owned(words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(owned.size() + 1);
  for (std::string& word : owned) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (::posix_spawnp(&child, arguments.front(), actions.get(), nullptr, arguments.data(), environ) != 0)
    return std::nullopt;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

std::string why_failed(int status, const MemoryFile& errors) {
  if (WIFSIGNALED(status)) return ::strsignal(WTERMSIG(status));
  const std::string all = errors.content();
  const std::size_t begin = std::min(all.find_first_not_of(" \n"), all.size());
  return all.substr(begin, all.find('\n', begin) - begin);
}

}  // namespace csgsim
