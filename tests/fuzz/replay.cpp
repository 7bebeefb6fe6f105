// Runs a libFuzzer target without libFuzzer: over the files of its corpus, and over mutations of them. Prints the time
// of the slowest case, and the peak memory. A case that ends the process, or takes longer than run.sh allows, is
// written to the file `finding` in the current folder.
//   replay ROUNDS MOST_BYTES DICTIONARY FILE...

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/address_sanitizer.h"
#include "tests/fuzz/property.h"

/// A target's own mutator, if it has one.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t most, unsigned seed);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

std::string content_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "replay: cannot read %s\n", path);
    std::exit(1);
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The words of a libFuzzer dictionary: one per line, in quotes, with \\, \" and \xNN.
std::vector<std::string> words_of(const char* dictionary) {
  std::vector<std::string> words;
  std::ifstream file(dictionary);
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find('"');
    const std::size_t end = line.rfind('"');
    if (line.starts_with('#') || begin == end) continue;
    std::string& word = words.emplace_back();
    for (std::size_t i = begin + 1; i < end; ++i) {
      if (line[i] == '\\' && line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
        i += 3;
      } else {
        word += line[i] == '\\' ? line[++i] : line[i];
      }
    }
  }
  return words;
}

/// Reproducible mutations of samples.
class Mutator {
 public:
  std::vector<std::string> samples;
  std::vector<std::string> words;

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t count = std::min(1 + below(30), text.size() - at);
    switch (below(6)) {
      case 0: text.erase(at, count); break;
      case 1: text.insert(at, words[below(words.size())]); break;
      case 2: text.replace(at, count, words[below(words.size())]); break;
      case 3: text.insert(below(text.size() + 1), text.substr(at, count)); break;
      case 4:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      default: {
        const std::string& other = samples[below(samples.size())];
        text.insert(at, other.substr(below(other.size() + 1), below(200)));
      }
    }
  }

 private:
  std::mt19937_64 random_{1987};
};

Mutator& mutator() {
  static Mutator one;
  return one;
}

constexpr double most_seconds = CSGSIM_ADDRESS_SANITIZER == 1 ? 100 : 10;
constexpr long most_kilobytes = 2048L * 1024;

/// The current input, for the signal handler.
std::string_view current;

void keep_finding() {
  const int file = open("finding", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file >= 0 && write(file, current.data(), current.size()) >= 0) close(file);
}

extern "C" void keep_and_end(int number) {
  keep_finding();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

double slowest = 0;  ///< processor seconds

void run(const std::string& text) {
  current = text;
  const std::clock_t begin = std::clock();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  slowest = std::max(slowest, seconds);
  if (seconds <= most_seconds) return;
  keep_finding();
  std::fprintf(stderr, "replay: a case took %.1f s; it is in the file 'finding'\n", seconds);
  std::exit(1);
}

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

std::string mutation(std::size_t most) {
  std::string text = mutator().samples[mutator().below(mutator().samples.size())];
  const std::size_t size = text.size();
  text.resize(std::max(size, most));
  auto* const bytes = reinterpret_cast<std::uint8_t*>(text.data());
  std::size_t used = size;
  for (std::size_t times = 1 + mutator().below(4); times > 0; --times) {
    const auto seed = static_cast<unsigned>(mutator().below(1U << 31U));
    used = LLVMFuzzerCustomMutator != nullptr ? LLVMFuzzerCustomMutator(bytes, used, text.size(), seed)
                                              : LLVMFuzzerMutate(bytes, used, text.size());
  }
  text.resize(used);
  return text;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most) {
  std::string text(reinterpret_cast<const char*>(data), size);
  mutator().mutate(text);
  text.resize(std::min(text.size(), most));
  if (!text.empty()) std::memcpy(data, text.data(), text.size());
  return text.size();
}

int main(int count, char** arguments) {
  if (count < 5) {
    std::fputs("usage: replay ROUNDS MOST_BYTES DICTIONARY FILE...\n", stderr);
    return 2;
  }
  const std::size_t most = std::strtoul(arguments[2], nullptr, 10);
  mutator().words = words_of(arguments[3]);
  if (mutator().words.empty()) {
    std::fprintf(stderr, "replay: there is no word in %s\n", arguments[3]);
    return 1;
  }
  for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(number, keep_and_end);
  for (int i = 4; i < count; ++i) {
    mutator().samples.push_back(content_of(arguments[i]));
    run(mutator().samples.back());
  }
  for (long rounds = std::strtol(arguments[1], nullptr, 10); rounds > 0; --rounds) run(mutation(most));
  std::printf("the slowest case took %.3f s, the most memory was %ld MiB\n", slowest, peak_kilobytes() / 1024);
  return peak_kilobytes() > most_kilobytes ? 1 : 0;
}
