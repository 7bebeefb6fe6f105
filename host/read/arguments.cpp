#include "host/read/arguments.h"

#include <algorithm>

namespace csgsim::read {

std::size_t ValueView::size() const {
  std::size_t count = 0;
  for_each([&](ValueView) { ++count; });
  return count;
}

Arguments::Arguments(Source& source, const Statement& statement, const NodeType& node,
                     const solids::MeshPlacement& mesh_placement)
    : source_(&source), statement_(&statement), node_(&node), mesh_placement_(mesh_placement) {
  std::size_t next_positional = 0;
  for (const Argument& argument : statement.arguments) {
    if (!argument.name.empty()) {
      bind(argument.name, argument);
    } else if (next_positional < node.positional) {
      bind(node.parameters[next_positional++], argument);
    } else {
      source.fail(argument.offset, fmt::format("{}() accepts at most {} unnamed arguments; name this one or remove it",
                                               node.name, node.positional));
    }
  }
}

void Arguments::bind(std::string_view name, const Argument& argument) {
  if (std::ranges::find(node_->parameters, name) == node_->parameters.end() &&
      std::ranges::find(node_->harmless, name) == node_->harmless.end()) {
    source_->fail(argument.offset, unknown_argument_text(*node_, name));
  }
  if (std::ranges::find(bound_, name, &Bound::name) != bound_.end()) {
    source_->fail(argument.offset, fmt::format("{} is given twice in {}(...); remove one", name, node_->name));
  }
  bound_.push_back({name, argument.value});
}

std::optional<ValueView> Arguments::find_any(std::string_view name) const {
  const auto found = std::ranges::find(bound_, name, &Bound::name);
  if (found == bound_.end()) return std::nullopt;
  return ValueView(statement_->values, found->value);
}

std::optional<ValueView> Arguments::find(std::string_view name) const {
  const std::optional<ValueView> value = find_any(name);
  if (value && value->is(ValueKind::undefined)) return std::nullopt;
  return value;
}

bool Arguments::is_undefined(std::string_view name) const {
  const std::optional<ValueView> value = find_any(name);
  return value && value->is(ValueKind::undefined);
}

std::optional<double> Arguments::number(std::string_view name) const {
  const std::optional<ValueView> value = find(name);
  if (!value) return std::nullopt;
  return read_number(*value, name);
}

std::optional<bool> Arguments::boolean(std::string_view name) const {
  const std::optional<ValueView> value = find(name);
  if (!value) return std::nullopt;
  if (!value->is(ValueKind::boolean)) fail(*value, "{} of {}() must be true or false", name, node_->name);
  return value->value().number != 0;
}

std::optional<std::string> Arguments::text(std::string_view name) const {
  const std::optional<ValueView> value = find(name);
  if (!value) return std::nullopt;
  if (!value->is(ValueKind::string)) fail(*value, "{} of {}() must be a \"string\"", name, node_->name);
  std::string text(
      source_->text().substr(value->value().offset + std::size_t{1}, static_cast<std::size_t>(value->value().number)));
  for (std::size_t at = text.find("\\\""); at != std::string::npos; at = text.find("\\\"", at + 1)) text.erase(at, 1);
  return text;
}

std::optional<ImportedFile> Arguments::file(const InputKind& kind) const {
  const std::optional<std::string> name = text("file");
  if (!name) fail("the argument file is missing; add file = \"name\"");
  if (!name->empty()) return source_->import(*name, kind, node_->name, statement_->offset);
  source_->print_message(statement_->offset, fmt::format("{}() names no file and is empty; name one", node_->name));
  return std::nullopt;
}

ValueView Arguments::required(std::string_view name, std::string_view form) const {
  const std::optional<ValueView> value = find(name);
  if (!value) fail("{}() lacks its {}; add {}", node_->name, name, form);
  return *value;
}

double Arguments::read_number(ValueView value, std::string_view description) const {
  if (!value.is(ValueKind::number)) fail(value, "{} of {}() must be a number", description, node_->name);
  return value.value().number;
}

}  // namespace csgsim::read
