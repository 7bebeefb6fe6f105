// Preloaded into csgsim (LD_PRELOAD) by mutate_files.py: in place of main() it serves runs of main(), each in a child
// that is forked after all libraries are loaded, which takes a tenth of the time of a start. Children inherit the
// server's limits.
//
// A request on descriptor 3 consists of the number of bytes that follow, then words, each ended by 0: the folder, the
// file for standard error, and main's arguments. The answers on descriptor 4 are the child's process id, and its wait
// status at its end.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using Main = int (*)(int, char**, char**);

constexpr int requests = 3;
constexpr int answers = 4;

Main csgsims_main = nullptr;

bool read_all(void* place, std::size_t count) {
  char* const bytes = static_cast<char*>(place);
  for (std::size_t done = 0; done < count;) {
    const ssize_t more = ::read(requests, bytes + done, count - done);
    if (more <= 0) return false;
    done += static_cast<std::size_t>(more);
  }
  return true;
}

void answer(std::int32_t number) {
  if (::write(answers, &number, sizeof number) != sizeof number) std::_Exit(127);
}

void connect(const char* file, int flags, int number) {
  const int opened = ::open(file, flags, 0600);
  if (opened < 0 || ::dup2(opened, number) != number) std::_Exit(127);
  ::close(opened);
}

[[noreturn]] void run(std::vector<char*> words, char** environment) {
  ::close(requests);
  ::close(answers);
  ::setsid();
  if (::chdir(words[0]) != 0) std::_Exit(127);
  connect("/dev/null", O_RDONLY, STDIN_FILENO);
  connect("/dev/null", O_WRONLY, STDOUT_FILENO);
  connect(words[1], O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  words.push_back(nullptr);
  std::exit(csgsims_main(static_cast<int>(words.size()) - 3, words.data() + 2, environment));
}

int serve(int, char**, char** environment) {
  ::unsetenv("LD_PRELOAD");
  std::uint32_t count = 0;
  while (read_all(&count, sizeof count)) {
    std::string text(count, '\0');
    if (!read_all(text.data(), count)) break;
    std::vector<char*> words;
    for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1) words.push_back(text.data() + at);
    const pid_t child = ::fork();
    if (child < 0) return 1;
    if (child == 0) run(words, environment);
    answer(child);
    int status = 0;
    ::waitpid(child, &status, 0);
    answer(status);
  }
  return 0;
}

}  // namespace

extern "C" int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*rtld_fini)(),
                                 void* stack_end) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  csgsims_main = main;
  const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(serve, argc, argv, init, fini, rtld_fini, stack_end);
}
