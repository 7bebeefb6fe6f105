#include "tests/waves/vcd.h"

#include <iterator>
#include <sstream>
#include <stdexcept>

namespace csgsim::test {

namespace {

std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "\\x") == 0) {
      result += static_cast<char>(std::stoi(text.substr(i + 2, 2), nullptr, 16));
      i += 3;
    } else {
      result += text[i];
    }
  }
  return result;
}

}  // namespace

Vcd::Vcd(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> scopes;
  std::string word;
  const auto skip_to_end = [&] {
    while (in >> word && word != "$end") continue;
  };
  while (in >> word && word != "$enddefinitions") {
    if (word == "$scope") {
      std::string kind;
      in >> kind >> word;
      scopes.push_back(word);
      skip_to_end();
    } else if (word == "$upscope") {
      scopes.pop_back();
      skip_to_end();
    } else if (word == "$var") {
      std::string type;
      std::string width;
      std::string code;
      std::string name;
      in >> type >> width >> code >> name;
      std::string full;
      for (const std::string& scope : scopes) full += scope + ".";
      if (!codes_.emplace(full + name, code).second) throw std::runtime_error("two variables " + full + name);
      if (!changes_.emplace(code, Changes{}).second) throw std::runtime_error("two variables of code " + code);
      skip_to_end();
    } else {
      skip_to_end();
    }
  }
  skip_to_end();
  std::optional<std::uint64_t> now;
  while (in >> word) {
    if (word.front() == '$') continue;
    if (word.front() == '#') {
      const std::uint64_t time = std::stoull(word.substr(1));
      if (now && time < *now) throw std::runtime_error("the time goes back to " + word);
      if (!now) first_time_ = time;
      now = time;
      last_time_ = time;
      continue;
    }
    std::string value = word.substr(1);
    std::string code;
    if (word.front() == 'b') {
      in >> code;
    } else if (word.front() == 's') {
      in >> code;
      value = unescaped(value);
    } else {
      code = value;
      value = word.substr(0, 1);
    }
    if (!now) throw std::runtime_error("a value before the first time");
    changes_.at(code)[*now] = value;
  }
}

std::vector<std::string> Vcd::names() const {
  std::vector<std::string> names;
  for (const auto& [name, code] : codes_) names.push_back(name);
  return names;
}

std::string Vcd::at(const std::string& name, std::uint64_t time) const {
  const Changes& changes = changes_.at(codes_.at(name));
  const auto after = changes.upper_bound(time);
  if (after == changes.begin()) throw std::out_of_range(name + " has no value yet");
  return std::prev(after)->second;
}

std::optional<std::uint64_t> Vcd::number_at(const std::string& name, std::uint64_t time) const {
  const std::string value = at(name, time);
  if (value.empty() || value.find_first_not_of("01") != std::string::npos) return std::nullopt;
  return std::stoull(value, nullptr, 2);
}

}  // namespace csgsim::test
