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

/// A value of a statement and, if it is a vector, those in it. Valid as long as the statement.
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

  /// How many elements a vector has.
  [[nodiscard]] std::size_t size() const;

 private:
  const std::vector<Value>* values_;
  std::uint32_t index_;
};

/// The arguments of a statement by name. Every reader throws InputError at the place of a value of the wrong kind; an
/// argument that is `undef` counts as absent.
class Arguments {
 public:
  /// Gives names to positional arguments. Throws InputError if one is unknown, given twice or too many.
  Arguments(Source& source, const Statement& statement, const NodeType& node,
            const solids::MeshPlacement& mesh_placement);

  /// Where what the node makes stands.
  [[nodiscard]] const solids::MeshPlacement& mesh_placement() const { return mesh_placement_; }

  [[nodiscard]] std::optional<ValueView> find(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name).has_value(); }
  /// Whether it is there and `undef`.
  [[nodiscard]] bool is_undefined(std::string_view name) const;
  [[nodiscard]] std::optional<double> number(std::string_view name) const;
  [[nodiscard]] std::optional<bool> boolean(std::string_view name) const;
  /// A string as it stands between its quotes, but for \\", which is a quote.
  [[nodiscard]] std::optional<std::string> text(std::string_view name) const;

  /// The file that the argument `file` names. None if the name is empty, or there is no file of that name: that is
  /// told, and the node is empty as in OpenSCAD. Throws InputError, at the name of the node, as Source::import() does,
  /// and where the argument is absent.
  [[nodiscard]] std::optional<ImportedFile> file(const InputKind& kind) const;

  /// See Source::work().
  [[nodiscard]] const Work& work() const { return source_->work(); }

  /// The vector of that name; absence is an error, which shows `form` (`size = [x, y, z]`).
  [[nodiscard]] ValueView required(std::string_view name, std::string_view form) const;

  /// Up to N numbers from a vector of at least `least`; the others keep what `into` has.
  template <std::size_t N>
  void read_numbers(ValueView vector, std::size_t least, std::array<double, N>& into, std::string_view what) const {
    if (!vector.is(ValueKind::vector) || vector.size() < least || vector.size() > N) {
      fail(vector, "{} of {}() must be a vector of {} numbers", what, node_->name,
           least == N ? fmt::to_string(N) : fmt::format("{} or {}", least, N));
    }
    auto out = into.begin();
    vector.for_each([&](ValueView element) { *out++ = read_number(element, what); });
  }

  [[nodiscard]] double read_number(ValueView value, std::string_view what) const;

  /// Tells it at a value, on standard error.
  void tell(ValueView at, std::string_view message) const { source_->tell(at.value().offset, message); }

  /// Tells it at the name of the node.
  void tell(std::string_view message) const { source_->tell(statement_->offset, message); }

  /// Throws InputError at a value.
  template <typename... Parts>
  [[noreturn]] void fail(ValueView at, fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->fail(at.value().offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

  /// Throws InputError at the name of the node.
  template <typename... Parts>
  [[noreturn]] void fail(fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->fail(statement_->offset, fmt::format(message, std::forward<Parts>(parts)...));
  }

  /// Tells of something at the name of the node, unless the same has been told at another node.
  template <typename... Parts>
  void tell_once(fmt::format_string<Parts...> message, Parts&&... parts) const {
    source_->tell_once(statement_->offset, fmt::format(message, std::forward<Parts>(parts)...));
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
