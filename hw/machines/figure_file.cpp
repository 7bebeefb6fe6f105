#include "hw/machines/figure_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/base/toml_text.h"
#include "hw/machines/quantity.h"
#include "hw/machines/schema.h"

namespace csgsim::machines {

namespace {

constexpr std::string_view provenances[] = {"published", "assumed"};
constexpr std::string_view figure_keys[] = {"value", "unit", "provenance", "source", "low", "high", "range"};
constexpr std::string_view range_keys[] = {"low", "high", "range"};

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// ` did you mean X?`, or an empty string if no known word is similar.
std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view near = nearest_similar(word, known);
  return near.empty() ? "" : fmt::format(" did you mean {}?", near);
}

class FigureReader {
 public:
  FigureReader(std::string_view file, const std::string& changed) : file_(file), changed_(changed) {}

  /// A parameter and its position in the file.
  struct Placed {
    toml::source_position place;
    ReadFigure read;
  };

  [[noreturn]] void fail(const toml::source_position& place, std::string_view message) const {
    if (!changed_.empty()) throw ChangeError(fmt::format("{}: {}", changed_, message));
    throw InputError(fmt::format("{}: {}", position_text(place, file_), message));
  }

  std::string text_of(const toml::table& table, std::string_view key) const {
    const toml::node* const node = table.get(key);
    if (node == nullptr) fail(table.source().begin, fmt::format("key '{0}' is missing; add {0} = \"...\"", key));
    const toml::value<std::string>* const text = node->as_string();
    if (text == nullptr) fail(node->source().begin, fmt::format("'{}' is {}; make it a string", key, type_name(*node)));
    if (text->get().empty()) fail(node->source().begin, fmt::format("'{}' is empty; give a value", key));
    return printable(text->get());
  }

  /// Reads the tables above the parameters; `prefix` is "" or a group's name and a dot.
  void read_group(const toml::table& table, const std::string& prefix, std::span<const FigureForm> forms,
                  std::span<const std::string_view> words, std::vector<Placed>& figures) const {
    std::vector<std::string_view> known(words.begin(), words.end());
    for (const FigureForm& form : forms)
      if (form.key.starts_with(prefix)) {
        const std::string_view rest = form.key.substr(prefix.size());
        const std::string_view word = rest.substr(0, rest.find('.'));
        if (!is_one_of(word, known)) known.push_back(word);
      }
    for (const auto& [key, node] : table) {
      if (!is_one_of(key.str(), known)) fail_unknown(key, known, prefix);
      if (is_one_of(key.str(), words)) continue;
      const std::string full = prefix + std::string(key.str());
      const auto form = std::ranges::find(forms, full, &FigureForm::key);
      if (form == forms.end()) {
        read_group(table_of(node, full), full + ".", forms, {}, figures);
      } else {
        ReadFigure read = read_figure(table_of(node, full), *form);
        read.form = static_cast<std::size_t>(form - forms.begin());
        figures.push_back({key.source().begin, std::move(read)});
      }
    }
  }

 private:
  const toml::table& table_of(const toml::node& node, std::string_view key) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr) fail(node.source().begin, fmt::format("'{}' is {}; make it a table", key, type_name(node)));
    return *table;
  }

  [[noreturn]] void fail_unknown(const toml::key& key, std::span<const std::string_view> known,
                                 std::string_view prefix) const {
    const std::string_view near = nearest_similar(key.str(), known);
    fail(key.source().begin, fmt::format("unknown key '{}{}'; {}", prefix, key.str(),
                                         near.empty() ? fmt::format("the keys here are {}", fmt::join(known, ", "))
                                                      : fmt::format("the nearest known is '{}{}'", prefix, near)));
  }

  ReadFigure read_figure(const toml::table& table, const FigureForm& form) const {
    for (const auto& [key, node] : table)
      if (!is_one_of(key.str(), figure_keys)) fail_unknown(key, figure_keys, std::string(form.key) + ".");

    const std::optional<Word> word = word_of(table, form);
    const std::int64_t value = word ? word->value : form.names.empty() ? value_of(table, form) : choice_of(table, form);
    const std::string text = word                 ? std::string(word->text)
                             : form.names.empty() ? fmt::format("{}", value)
                                                  : std::string(form.names[static_cast<std::size_t>(value)]);
    Figure figure{std::string(form.key), text, form.unit.empty() ? "" : text_of(table, "unit"),
                  text_of(table, "provenance"), text_of(table, "source")};
    if (form.unit.empty() && table.contains("unit"))
      fail(table.get("unit")->source().begin, fmt::format("{} has no unit; remove the key 'unit'", form.key));
    if (figure.unit != form.unit)
      fail(table.get("unit")->source().begin,
           fmt::format("{} has the unit '{}'; write '{}'", form.key, figure.unit, form.unit));
    if (!is_one_of(figure.provenance, provenances))
      fail(table.get("provenance")->source().begin,
           fmt::format("{} has the provenance '{}'; write 'published' or 'assumed'", form.key, figure.provenance));
    figure.range = range_of(table, form);
    return {0, value, std::move(figure)};
  }

  /// The range of a number; empty if the table has none.
  std::optional<FigureRange> range_of(const toml::table& table, const FigureForm& form) const {
    const auto first = std::ranges::find_if(range_keys, [&](std::string_view key) { return table.contains(key); });
    if (first == std::end(range_keys)) return std::nullopt;
    const toml::source_position& place = table.get(*first)->source().begin;
    if (!form.names.empty())
      fail(place, fmt::format("{} is a word, which has no range; remove '{}'", form.key, *first));
    for (const std::string_view key : range_keys)
      if (!table.contains(key))
        fail(place,
             fmt::format("{} has '{}' but no '{}'; give low, high and the reason, range", form.key, *first, key));
    const FigureRange range{number_at(table, form, "low"), number_at(table, form, "high"), text_of(table, "range")};
    if (range.low > range.high)
      fail(place, fmt::format("the range of {} is {} to {}; make low at most high", form.key, range.low, range.high));
    return range;
  }

  /// A word in place of a number, with its meaning.
  struct Word {
    std::string_view text;
    std::int64_t value = 0;
  };

  /// The words that the parameter takes.
  [[nodiscard]] static std::vector<Word> words_of(const FigureForm& form) {
    std::vector<Word> words;
    if (form.ideal) words.push_back({ideal_value, *form.ideal});
    if (form.priced) words.push_back({priced_value, *form.priced});
    return words;
  }

  [[nodiscard]] static std::optional<Word> word_of(const toml::table& table, const FigureForm& form) {
    const auto* const text = table.get_as<std::string>("value");
    if (text == nullptr) return std::nullopt;
    for (const Word& word : words_of(form))
      if (text->get() == word.text) return word;
    return std::nullopt;
  }

  /// Index of the value among its names.
  [[nodiscard]] std::int64_t choice_of(const toml::table& table, const FigureForm& form) const {
    const std::string name = text_of(table, "value");
    const auto found = std::ranges::find(form.names, name);
    if (found == form.names.end()) {
      fail(table.get("value")->source().begin, fmt::format("{} is '{}';{} it must be one of {}", form.key, name,
                                                           suggestion(name, form.names), fmt::join(form.names, ", ")));
    }
    return found - form.names.begin();
  }

  /// Words that the parameter also takes, for messages.
  [[nodiscard]] static std::string words_in_messages(const FigureForm& form) {
    std::string words;
    for (const Word& word : words_of(form)) words += fmt::format(", or \"{}\"", word.text);
    return words;
  }

  /// The value of a text with a unit, as in "20MHz".
  [[nodiscard]] std::int64_t quantity_of(const toml::node& node, std::string_view text, const FigureForm& form) const {
    try {
      return parse_quantity(text, form.unit);
    } catch (const InputError& error) {
      fail(node.source().begin, fmt::format("{} is '{}'; {}{}", form.key, text, error.what(), words_in_messages(form)));
    }
  }

  /// The number without its range.
  [[nodiscard]] std::int64_t number_of(const toml::node& node, const FigureForm& form) const {
    if (const toml::value<std::int64_t>* const value = node.as_integer()) return value->get();
    if (const toml::value<std::string>* const text = node.as_string()) return quantity_of(node, text->get(), form);
    const toml::value<double>* const value = node.as_floating_point();
    constexpr double max_exact = 9'007'199'254'740'992;  // 2^53
    const bool is_whole =
        value != nullptr && std::abs(value->get()) <= max_exact && std::trunc(value->get()) == value->get();
    if (is_whole) return static_cast<std::int64_t>(value->get());
    fail(node.source().begin,
         fmt::format("{} is {}; make it an integer{}", form.key, type_name(node), words_in_messages(form)));
  }

  [[nodiscard]] std::int64_t value_of(const toml::table& table, const FigureForm& form) const {
    if (!table.contains("value")) fail(table.source().begin, fmt::format("{} has no value; add value = ...", form.key));
    return number_at(table, form, "value");
  }

  /// The number at a key of the table, within the limits of the form.
  [[nodiscard]] std::int64_t number_at(const toml::table& table, const FigureForm& form, std::string_view key) const {
    const toml::node& node = *table.get(key);
    const std::int64_t value = number_of(node, form);
    if (value < form.least || value > form.most)
      fail(node.source().begin,
           form.least == form.most
               ? fmt::format("{} is {}; the simulator supports only {}", form.key, value, form.least)
               : fmt::format("{} is {}; it must be {} to {}{}{}", form.key, value, form.least, form.most,
                             form.unit.empty() ? "" : " ", form.unit));
    return value;
  }

  std::string_view file_;
  const std::string& changed_;
};

}  // namespace

FigureFile::FigureFile(const toml::table& root, std::string_view file, std::string changed)
    : root_(root), file_(file), changed_(std::move(changed)) {}

std::string FigureFile::text(std::string_view key) const { return FigureReader(file_, changed_).text_of(root_, key); }

std::vector<ReadFigure> FigureFile::figures(std::span<const FigureForm> forms,
                                            std::span<const std::string_view> words) const {
  using Placed = FigureReader::Placed;
  const FigureReader reader(file_, changed_);
  std::vector<Placed> placed;
  reader.read_group(root_, "", forms, words, placed);
  for (std::size_t form = 0; form < forms.size(); ++form) {
    if (std::ranges::any_of(placed, [form](const Placed& one) { return one.read.form == form; })) continue;
    reader.fail(root_.source().begin,
                fmt::format("key '{0}' is missing; add a table [{0}] with value, unit, provenance and source",
                            forms[form].key));
  }
  std::ranges::sort(placed, [](const Placed& a, const Placed& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
  std::vector<ReadFigure> figures;
  figures.reserve(placed.size());
  for (Placed& one : placed) figures.push_back(std::move(one.read));
  return figures;
}

void FigureFile::fail(std::string_view key, std::string_view message) const {
  const toml::node* const node = root_.at_path(key).node();
  FigureReader(file_, changed_).fail(node == nullptr ? root_.source().begin : node->source().begin, message);
}

}  // namespace csgsim::machines
