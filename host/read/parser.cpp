#include "host/read/parser.h"

#include <optional>

#include "host/read/limits.h"
#include "host/read/number.h"

namespace csgsim::read {

void Parser::add_modifier(std::string_view text) {
  statement_.modifiers.disable |= text == "*";
  statement_.modifiers.background |= text == "%";
  statement_.modifiers.root |= text == "!";
}

void Parser::name_statement(std::string_view text) {
  statement_.name = text;
  statement_.offset = static_cast<std::uint32_t>(offset_of(text.data()));
  if (++statements_ > max_statements) fail(statement_.offset, "more than {} nodes; split the model", max_statements);
}

void Parser::name_argument(std::string_view text) {
  argument_name_ = text.substr(0, text.find_first_of(" \t\r\n\v\f/="));
}

void Parser::finish_argument(std::string_view text) {
  statement_.arguments.push_back({argument_name_, static_cast<std::uint32_t>(offset_of(text.data())), argument_value_});
  argument_name_ = {};
  argument_value_ = static_cast<std::uint32_t>(statement_.values.size());
}

void Parser::add_value(std::string_view text, ValueKind kind, double number) {
  const std::size_t offset = offset_of(text.data());
  if (statement_.values.size() >= max_values)
    fail(offset, "more than {} values in one node; split the node", max_values);
  statement_.values.push_back({number, static_cast<std::uint32_t>(offset), kind, 1});
}

void Parser::add_number(std::string_view text) {
  const std::optional<double> number = parse_number(text);
  if (!number)
    fail(offset_of(text.data()), "number out of range: {} exceeds the range of doubles; correct it", shown(text));
  add_value(text, ValueKind::number, *number);
}

void Parser::open_vector(std::string_view text) {
  if (vectors_.size() >= max_vector_depth) {
    fail(offset_of(text.data()), "vectors are nested more than {} deep; no node needs this", max_vector_depth);
  }
  vectors_.push_back(static_cast<std::uint32_t>(statement_.values.size()));
  add_value(text, ValueKind::vector);
}

void Parser::close_vector(std::string_view /*text*/) {
  Value& vector = statement_.values[vectors_.back()];
  vector.extent = static_cast<std::uint32_t>(statement_.values.size()) - vectors_.back();
  vectors_.pop_back();
}

void Parser::finish_leaf(std::string_view /*text*/) {
  visitor_.begin(statement_);
  visitor_.end();
  clear_statement();
}

void Parser::open_braces(std::string_view text) {
  if (open_.size() >= max_depth)
    fail(offset_of(text.data()), "braces are nested more than {} deep; split the model", max_depth);
  open_.push_back({statement_.name, statement_.offset});
  visitor_.begin(statement_);
  clear_statement();
}

void Parser::close_braces(std::string_view text) {
  if (open_.empty()) fail(offset_of(text.data()), "unmatched `}}`; remove it");
  open_.pop_back();
  visitor_.end();
}

void Parser::finish_file() {
  if (open_.empty()) return;
  const auto [name, offset] = open_.back();
  const model::Location start = source_.locate(offset);
  fail(source_.text().size(), "expected `}}` to close {}() of line {}, column {}, found the end of the file",
       shown(name), start.line, start.column);
}

void Parser::fail_expecting(std::size_t offset, std::string_view expected) {
  fail(offset, "expected {}, found {}", expected, description_at(offset));
}

void Parser::fail_without_arguments(std::size_t offset) {
  const std::string_view name = statement_.name;
  const bool assigns = source_.text().substr(offset).starts_with('=');
  if (assigns || name == "module" || name == "function" || name == "use" || name == "include") {
    fail(statement_.offset, "this is OpenSCAD source, not .csg; export it first: openscad -o model.csg model.scad");
  }
  fail_expecting(offset, fmt::format("`(` after {}", shown(name)));
}

std::string Parser::description_at(std::size_t offset) const {
  const std::string_view text = source_.text();
  if (offset >= text.size()) return "the end of the file";
  const char first = text[offset];
  if (first > ' ' && first <= '~') return fmt::format("`{}`", first);
  return fmt::format("byte 0x{:02x}", static_cast<unsigned char>(first));
}

void Parser::clear_statement() {
  statement_.modifiers = {};
  statement_.arguments.clear();
  statement_.values.clear();
  argument_value_ = 0;
}

}  // namespace csgsim::read
