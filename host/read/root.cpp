#include "host/read/root.h"

namespace csgsim::read {

namespace {

class RootFinder : public StatementVisitor {
 public:
  void begin(const Statement& statement) override {
    if (disabled_ > 0 || statement.modifiers.disable) {
      ++disabled_;
    } else if (statement.modifiers.root && !root_) {
      root_ = count_;
    }
    ++count_;
  }

  void end() override {
    if (disabled_ > 0) --disabled_;
  }

  [[nodiscard]] std::optional<std::uint32_t> root() const { return root_; }

 private:
  std::optional<std::uint32_t> root_;
  std::uint32_t count_ = 0;
  std::uint32_t disabled_ = 0;  ///< number of open statements, from the outermost one with `*` inwards
};

}  // namespace

std::optional<std::uint32_t> find_root_statement(Source& source) {
  if (source.text().find('!') == std::string_view::npos) return std::nullopt;
  RootFinder finder;
  visit_statements(source, finder);
  return finder.root();
}

void DrawnFilter::begin(const Statement& statement) {
  const bool is_root = depth_ == 0 && root_ == count_;
  ++count_;
  if (root_ && depth_ == 0 && !is_root) return;
  ++depth_;
  const bool is_left_out = !is_root && (statement.modifiers.disable || statement.modifiers.background);
  if (left_out_ > 0 || is_left_out) {
    ++left_out_;
  } else {
    visitor_.begin(statement);
  }
}

void DrawnFilter::end() {
  if (depth_ == 0) return;
  --depth_;
  if (left_out_ > 0) {
    --left_out_;
  } else {
    visitor_.end();
  }
}

}  // namespace csgsim::read
