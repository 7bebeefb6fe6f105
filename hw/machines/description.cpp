#include "hw/machines/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/base/toml_text.h"
#include "hw/machines/schema.h"

namespace csgsim::machines {

namespace {

constexpr std::string_view provenances[] = {"published", "assumed"};
constexpr std::string_view figure_keys[] = {"value", "unit", "provenance", "source"};

class Reader {
 public:
  /// Where `changed` says something, the file is known to be right, and what is wrong is what was changed.
  Reader(std::string_view file, std::span<const Kind* const> kinds, std::string changed = {})
      : file_(file), kinds_(kinds), changed_(std::move(changed)) {}

  Machine read(const toml::table& root) {
    read_kind(root);
    read_group(root, "");
    machine_.name = text_of(root, "name");
    machine_.description = text_of(root, "description");
    for (const FigureSchema& figure : schema())
      if (!seen(figure))
        fail(root.source().begin,
             fmt::format("key '{0}' is missing; add a table [{0}] with value, unit, provenance and "
                         "source",
                         figure.key));
    std::sort(figures_.begin(), figures_.end(), [](const Placed& a, const Placed& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    for (Placed& placed : figures_) machine_.figures.push_back(std::move(placed.figure));
    complete(root);
    return std::move(machine_);
  }

 private:
  struct Placed {
    toml::source_position place;
    Figure figure;
  };

  [[noreturn]] void fail(const toml::source_position& place, std::string_view message) const {
    if (!changed_.empty()) throw ChangeError(fmt::format("{}: {}", changed_, message));
    throw InputError(fmt::format("{}: {}", show(place, file_), message));
  }

  [[nodiscard]] bool seen(const FigureSchema& schema) const {
    return std::any_of(figures_.begin(), figures_.end(),
                       [&schema](const Placed& placed) { return placed.figure.key == schema.key; });
  }

  const toml::table& table_of(const toml::node& node, std::string_view key) const {
    const toml::table* const table = node.as_table();
    if (table == nullptr) fail(node.source().begin, fmt::format("'{}' is {}; make it a table", key, type_name(node)));
    return *table;
  }

  /// The string at that key of the table, not empty, as people may see it.
  std::string text_of(const toml::table& table, std::string_view key) const {
    const toml::node* const node = table.get(key);
    if (node == nullptr) fail(table.source().begin, fmt::format("key '{0}' is missing; add {0} = \"...\"", key));
    const toml::value<std::string>* const text = node->as_string();
    if (text == nullptr) fail(node->source().begin, fmt::format("'{}' is {}; make it a string", key, type_name(*node)));
    if (text->get().empty()) fail(node->source().begin, fmt::format("'{}' is empty; say it", key));
    return printable(text->get());
  }

  void read_kind(const toml::table& root) {
    const std::string kind = text_of(root, "kind");
    const auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind* one) { return one->name == kind; });
    if (found == kinds_.end()) {
      std::vector<std::string_view> names;
      for (const Kind* one : kinds_) names.push_back(one->name);
      fail(root.get("kind")->source().begin,
           fmt::format("unknown kind '{}'; there are {}", kind, fmt::join(names, ", ")));
    }
    machine_ = blank(**found);
  }

  void complete(const toml::table& root) {
    try {
      machines::complete(machine_);
      set_picture_size(machine_, machine_.picture);
    } catch (const InputError& error) {
      const toml::node* const picture = root.get("picture");
      fail(picture == nullptr ? root.source().begin : picture->source().begin, error.what());
    }
  }

  [[nodiscard]] std::span<const FigureSchema> schema() const { return machine_.kind->schema; }

  /// The tables above the figures: prefix is "" or a group's name and a dot.
  void read_group(const toml::table& table, const std::string& prefix) {
    std::vector<std::string_view> known;
    if (prefix.empty()) known = {"name", "description", "kind"};
    for (const FigureSchema& figure : schema())
      if (figure.key.starts_with(prefix)) {
        const std::string_view rest = figure.key.substr(prefix.size());
        known.push_back(rest.substr(0, rest.find('.')));
      }
    for (const auto& [key, node] : table) {
      const std::string full = prefix + std::string(key.str());
      if (std::find(known.begin(), known.end(), key.str()) == known.end()) fail_unknown(key, known, prefix);
      const auto figure = std::find_if(schema().begin(), schema().end(),
                                       [&](const FigureSchema& candidate) { return candidate.key == full; });
      if (figure != schema().end())
        read_figure(table_of(node, full), *figure, key.source().begin);
      else if (full != "name" && full != "description" && full != "kind")
        read_group(table_of(node, full), full + ".");
    }
  }

  [[noreturn]] void fail_unknown(const toml::key& key, std::span<const std::string_view> known,
                                 std::string_view prefix) const {
    fail(key.source().begin, fmt::format("unknown key '{0}{1}'; the nearest known is '{0}{2}'", prefix, key.str(),
                                         nearest(key.str(), known)));
  }

  void read_figure(const toml::table& table, const FigureSchema& schema, const toml::source_position& place) {
    for (const auto& [key, node] : table)
      if (std::find(std::begin(figure_keys), std::end(figure_keys), key.str()) == std::end(figure_keys))
        fail_unknown(key, figure_keys, std::string(schema.key) + ".");

    const bool is_ideal = says_ideal(table, schema);
    const std::int64_t value = is_ideal               ? *schema.ideal
                               : schema.names.empty() ? value_of(table, schema)
                                                      : choice_of(table, schema);
    schema.store(machine_, value);
    const std::string text = is_ideal               ? std::string(ideal_value)
                             : schema.names.empty() ? fmt::format("{}", value)
                                                    : std::string(schema.names[static_cast<std::size_t>(value)]);
    Figure figure{std::string(schema.key), text, schema.unit.empty() ? "" : text_of(table, "unit"),
                  text_of(table, "provenance"), text_of(table, "source")};
    if (schema.unit.empty() && table.contains("unit"))
      fail(table.get("unit")->source().begin, fmt::format("{} has no unit; leave it out", schema.key));
    if (figure.unit != schema.unit)
      fail(table.get("unit")->source().begin,
           fmt::format("unit '{}' of {}; it counts in '{}'", figure.unit, schema.key, schema.unit));
    if (std::find(std::begin(provenances), std::end(provenances), figure.provenance) == std::end(provenances))
      fail(table.get("provenance")->source().begin,
           fmt::format("provenance '{}' of {}; say 'published' or 'assumed'", figure.provenance, schema.key));
    figures_.push_back({place, std::move(figure)});
  }

  [[nodiscard]] static bool says_ideal(const toml::table& table, const FigureSchema& schema) {
    const auto* const text = table.get_as<std::string>("value");
    return schema.ideal && text != nullptr && text->get() == ideal_value;
  }

  /// Which of its names the value is.
  [[nodiscard]] std::int64_t choice_of(const toml::table& table, const FigureSchema& schema) const {
    const std::string name = text_of(table, "value");
    const auto found = std::find(schema.names.begin(), schema.names.end(), name);
    if (found == schema.names.end()) {
      fail(table.get("value")->source().begin,
           fmt::format("{} is '{}'; it takes {}", schema.key, name, fmt::join(schema.names, ", ")));
    }
    return found - schema.names.begin();
  }

  [[nodiscard]] std::int64_t value_of(const toml::table& table, const FigureSchema& schema) const {
    const toml::node* const node = table.get("value");
    if (node == nullptr) fail(table.source().begin, fmt::format("{} has no value; add value = ...", schema.key));
    const toml::value<std::int64_t>* const value = node->as_integer();
    if (value == nullptr)
      fail(node->source().begin, fmt::format("{} is {}; make it an integer{}", schema.key, type_name(*node),
                                             schema.ideal ? ", or \"ideal\"" : ""));
    if (value->get() < schema.least || value->get() > schema.most)
      fail(node->source().begin,
           schema.least == schema.most
               ? fmt::format("{} is {}; the simulator knows {} only", schema.key, value->get(), schema.least)
               : fmt::format("{} is {}; it takes {} to {}{}{}", schema.key, value->get(), schema.least, schema.most,
                             schema.unit.empty() ? "" : " ", schema.unit));
    return value->get();
  }

  std::string_view file_;
  std::span<const Kind* const> kinds_;
  std::string changed_;
  Machine machine_;
  std::vector<Placed> figures_;
};

/// Every figure of a description, by key: tables that hold a value.
void collect_figures(toml::table& table, const std::string& prefix, std::map<std::string, toml::table*>& figures) {
  for (auto&& [key, node] : table) {
    toml::table* const inner = node.as_table();
    if (inner == nullptr) continue;
    const std::string full = prefix + std::string(key.str());
    if (inner->contains("value")) figures.emplace(full, inner);
    collect_figures(*inner, full + ".", figures);
  }
}

/// Changes the figure, and returns its key.
std::string put_change(toml::table& root, const std::string& change, std::string_view file) {
  const std::size_t equals = change.find('=');
  if (equals == change.npos) {
    throw ChangeError(fmt::format("{}: '{}' changes no figure; say KEY=VALUE", file, printable(change)));
  }
  std::map<std::string, toml::table*> figures;
  collect_figures(root, "", figures);
  std::string key = change.substr(0, equals);
  const auto found = figures.find(key);
  if (found == figures.end()) {
    std::vector<std::string_view> known;
    known.reserve(figures.size());
    for (const auto& [name, table] : figures) known.push_back(name);
    throw ChangeError(fmt::format("{}: unknown figure '{}'; the nearest known is '{}'", file, printable(key),
                                  known.empty() ? "none" : nearest(key, known)));
  }
  const std::string value = change.substr(equals + 1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error == std::errc() && end == value.data() + value.size()) {
    found->second->insert_or_assign("value", number);
  } else {
    found->second->insert_or_assign("value", value);
  }
  found->second->insert_or_assign("provenance", "assumed");
  found->second->insert_or_assign("source", "said with the machine's name");
  return key;
}

/// What tells the changed machine from others: each figure that was changed, once, with the value that it has.
std::string name_of_changes(const std::vector<std::string>& keys, const Machine& machine) {
  std::string name;
  for (auto key = keys.begin(); key != keys.end(); ++key) {
    if (std::find(keys.begin(), key, *key) != key) continue;
    const auto figure = std::find_if(machine.figures.begin(), machine.figures.end(),
                                     [&](const Figure& one) { return one.key == *key; });
    name += fmt::format("+{}={}", *key, figure->value);
  }
  return name;
}

}  // namespace

Machine read_description(std::string_view text, std::string_view file, std::span<const Kind* const> kinds,
                         std::span<const std::string> changes) {
  toml::table root = parse_toml(text, file);
  Machine machine = Reader(file, kinds).read(root);
  if (changes.empty()) return machine;
  std::vector<std::string> keys;
  std::string said(file);
  for (const std::string& change : changes) {
    keys.push_back(put_change(root, change, file));
    said += "+" + printable(change);
  }
  machine = Reader(file, kinds, said).read(root);
  machine.name += name_of_changes(keys, machine);
  return machine;
}

}  // namespace csgsim::machines
