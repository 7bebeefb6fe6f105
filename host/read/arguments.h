// Typed access to the arguments of a `.csg` statement.
// Used throughout host/read.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/read/nodes.h"
#include "host/read/source.h"
#include "host/read/syntax.h"
#include "host/solids/check.h"

namespace csgsim::read {

/// A value of a statement; if it is a vector, gives access to its elements. Valid as long as the statement.
class ValueView {
 public:
  ValueView(const std::vector<Value>& values, std::uint32_t index) : values_(&values), index_(index) {}

  [[nodiscard]] const Value& value() const { return (*values_)[index_]; }
  [[nodiscard]] bool is(ValueKind kind) const { return value().kind == kind; }

  /// Calls `visit(ValueView)` for each element of a vector.
  template <typename Visit>
  void for_each(Visit visit) const {
    const std::uint32_t end = index_ + value().extent;
    for (std::uint32_t i = index_ + 1; i < end; i += (*values_)[i].extent) visit(ValueView(*values_, i));
  }

  /// Number of elements of a vector.
  [[nodiscard]] std::size_t size() const;

 private:
  const std::vector<Value>* values_;
  std::uint32_t index_;
};

/// The arguments of a statement by name. Every reader throws InputError at the position of a value of the wrong kind;
/// an argument that is `undef` counts as absent.
class Arguments {
 public:
  /// Assigns parameter names to positional arguments. Throws InputError for an unknown argument, an argument given
  /// twice, and too many arguments.
  Arguments(Source& source, const Statement& statement, const NodeType& node,
            const solids::MeshPlacement& mesh_placement);

  /// Where the result of the node is placed.
  [[nodiscard]] const solids::MeshPlacement& mesh_placement() const { return mesh_placement_; }

  [[nodiscard]] std::optional<ValueView> find(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name).has_value(); }
  /// Whether the argument is present and `undef`.
  [[nodiscard]] bool is_undefined(std::string_view name) const;
  [[nodiscard]] std::optional<double> number(std::string_view name) const;
  [[nodiscard]] std::optional<bool> boolean(std::string_view name) const;
  /// The content of a string; \\" is replaced by a quote.
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const;

  /// The file named by the argument `file`. Empty if the name is empty or the file does not exist: a message reports
  /// this, and the node is empty as in OpenSCAD. Throws InputError at the name of the node if the argument is absent,
  /// and where Source::import() does.
  [[nodiscard]] std::optional<ImportedFile> file(const InputKind& kind) const;

  /// The work counter of the source; see Source::set_work_counter().
  [[nodiscard]] const Work& work() const { return source_->work(); }

  /// The argument `name`. Throws InputError if it is absent; `form`, as in `size = [x, y, z]`, is part of the message.
  [[nodiscard]] ValueView required(std::string_view name, std::string_view form) const;

  /// Reads at least `min_count` and at most N numbers from a vector; the other elements of `numbers` keep their values.
  template <std::size_t N>
  void read_numbers(ValueView vector, std::size_t min_count, std::array<double, N>& numbers,
                    std::string_view description) const {
    if (!vector.is(ValueKind::vector) || vector.size() < min_count || vector.size() > N) {
      fail(vector, "{} of {}() must be a vector of {} numbers", description, node_->name,
           min_count == N ? fmt::to_string(N) : fmt::format("{} or {}", min_count, N));
    }
    auto out = numbers.begin();
    vector.for_each([&](ValueView element) { *out++ = read_number(element, description); });
  }

  [[nodiscard]] double read_number(ValueView value, std::string_view description) const;

  /// Prints a message to standard error, with the position of a value.
  void report(ValueView value, std::string_view message) const {
    source_->print_message(value.value().offset, message);
  }

  /// Prints a message to standard error, with the position of the node's name.
  void report(std::string_view message) const { source_->print_message(statement_->offset, message); }

  /// Throws InputError at the position of a value.
  template <typename... Parts>
  [[noreturn]] void fail(ValueView value, fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->fail(value.value().offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

  /// Throws InputError at the position of the node's name.
  template <typename... Parts>
  [[noreturn]] void fail(fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->fail(statement_->offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

  /// Prints a message with the position of the node's name, unless the same message was printed before.
  template <typename... Parts>
  void warn_once(fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->warn_once(statement_->offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

 private:
  struct Bound {
    std::string_view name;
    std::uint32_t value;
  };

  void bind(std::string_view name, const Argument& argument);
  [[nodiscard]] std::optional<ValueView> find_any(std::string_view name) const;

  Source* source_;
  const Statement* statement_;
  const NodeType* node_;
  solids::MeshPlacement mesh_placement_;
  std::vector<Bound> bound_;
};

}  // namespace csgsim::read
