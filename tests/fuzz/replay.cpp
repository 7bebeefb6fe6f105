// Runs a libFuzzer target without libFuzzer: over the given files, and over mutations of them.
//   replay ROUNDS FILE...

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Mutations of texts, the same ones at every run.
class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& samples) : samples_(samples) {}

  std::string next() {
    std::string text = samples_[below(samples_.size())];
    for (std::size_t times = 1 + below(4); times > 0; --times) mutate(text);
    return text;
  }

 private:
  static constexpr std::string_view tokens[] = {"{", "}",   "(",    ")",     "[",    "]",     ",",     ";",
                                                "-", "inf", "nan",  "1e999", "0",    "1e-9",  "!",     "*",
                                                "%", "#",   "/*",   "*/",    "//",   "\"",    "undef", "=",
                                                "1", "\n",  "true", "hull(", "[[[[", "cube(", "1e308", "\xEF\xBB\xBF"};

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t count = std::min(1 + below(30), text.size() - at);
    switch (below(6)) {
      case 0: text.erase(at, count); break;
      case 1: text.insert(at, tokens[below(std::size(tokens))]); break;
      case 2: text.replace(at, count, tokens[below(std::size(tokens))]); break;
      case 3: text.insert(below(text.size() + 1), text.substr(at, count)); break;
      case 4:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      default: {
        const std::string& other = samples_[below(samples_.size())];
        text.insert(at, other.substr(below(other.size() + 1), below(200)));
      }
    }
  }

  const std::vector<std::string>& samples_;
  std::mt19937_64 random_{1987};
};

void run(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: replay ROUNDS FILE...\n", stderr);
    return 2;
  }
  std::vector<std::string> samples;
  for (int i = 2; i < count; ++i) {
    std::ifstream file(arguments[i], std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "replay: cannot read %s\n", arguments[i]);
      return 1;
    }
    samples.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    run(samples.back());
  }
  Mutator mutator(samples);
  for (long rounds = std::strtol(arguments[1], nullptr, 10); rounds > 0; --rounds) run(mutator.next());
  return 0;
}
