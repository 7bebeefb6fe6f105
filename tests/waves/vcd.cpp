#include "tests/waves/vcd.h"

#include <iterator>
#include <set>
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

/// Checks the sections of a dump and their contents.
class Sections {
 public:
  explicit Sections(std::size_t variables) : variables_(variables) {}

  void keyword(const std::string& word, std::uint64_t time) {
    if (word == "$end") return close();
    require(open_.empty(), word + " in " + open_);
    if (word == "$dumpvars") {
      require(!has_begun_, "a second $dumpvars");
    } else if (word == "$dumpoff") {
      require(has_begun_ && !is_off_, "$dumpoff where nothing is dumped");
      off_since_ = time;
    } else {
      require(word == "$dumpon", "unknown keyword " + word);
      require(is_off_ && time > off_since_, "$dumpon where nothing was off");
    }
    open_ = word;
  }

  void value(const std::string& code, const std::string& value) {
    if (open_.empty()) return require(has_begun_ && !is_off_, "a value where nothing is dumped");
    require(given_.insert(code).second, "two values of a variable in " + open_);
    require(open_ != "$dumpoff" || value == "x" || value == "-", "a value in $dumpoff");
  }

 private:
  static void require(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error(what);
  }

  void close() {
    require(!open_.empty(), "$end without a section");
    require(given_.size() == variables_, open_ + " without all variables");
    has_begun_ = true;
    is_off_ = open_ == "$dumpoff";
    open_.clear();
    given_.clear();
  }

  std::size_t variables_;
  std::string open_;             ///< keyword of the current section; empty between sections
  std::set<std::string> given_;  ///< codes that occurred in it
  bool has_begun_ = false;
  bool is_off_ = false;
  std::uint64_t off_since_ = 0;
};

}  // namespace

Vcd::Vcd(std::string_view text) {
  std::istringstream in{std::string(text)};
  read_header(in);
  read_changes(in);
}

void Vcd::read_header(std::istream& in) {
  std::vector<std::string> scopes;
  std::string word;
  const auto skip_to_end = [&] {
    while (word != "$end" && in >> word) continue;
  };
  while (in >> word && word != "$enddefinitions") {
    if (word == "$scope") {
      std::string kind;
      in >> kind >> word;
      scopes.push_back(word);
    } else if (word == "$upscope") {
      scopes.pop_back();
    } else if (word == "$var") {
      std::string type;
      std::string width;
      std::string code;
      std::string name;
      in >> type >> width >> code >> name >> word;
      std::string full;
      for (const std::string& scope : scopes) full += scope + ".";
      full += name;
      if (!codes_.emplace(full, code).second) throw std::runtime_error("duplicate variable " + full);
      if (!changes_.emplace(code, Changes{}).second) throw std::runtime_error("duplicate variable code " + code);
      if (word != "$end" && word != "[" + std::to_string(std::stoul(width) - 1) + ":0]")
        throw std::runtime_error(full + " of " + width + " bits has the range " + word);
    }
    skip_to_end();
  }
  skip_to_end();
}

void Vcd::read_changes(std::istream& in) {
  Sections sections(changes_.size());
  std::optional<std::uint64_t> now;
  for (std::string word; in >> word;) {
    if (word.front() == '#') {
      const std::uint64_t time = std::stoull(word.substr(1));
      if (now && time < *now) throw std::runtime_error("time decreases to " + word);
      if (!now) first_time_ = time;
      now = time;
      last_time_ = time;
      continue;
    }
    if (!now) throw std::runtime_error(word + " before the first time");
    if (word.front() == '$') {
      sections.keyword(word, *now);
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
    sections.value(code, value);
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
