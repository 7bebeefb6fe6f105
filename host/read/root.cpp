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
  std::uint32_t disabled_ = 0;  ///< open statements from a `*` on
};

}  // namespace

std::optional<std::uint32_t> find_root(Source& source) {
  if (source.text().find('!') == std::string_view::npos) return std::nullopt;
  RootFinder finder;
  visit_statements(source, finder);
  return finder.root();
}

void RootFilter::begin(const Statement& statement) {
  if (depth_ > 0) {
    ++depth_;
    visitor_.begin(statement);
  } else if (!is_past_ && until_root_ == 0) {
    is_past_ = true;
    depth_ = 1;
    Statement root = statement;
    root.modifiers = {};
    visitor_.begin(root);
  } else if (!is_past_) {
    --until_root_;
  }
}

void RootFilter::end() {
  if (depth_ == 0) return;
  --depth_;
  visitor_.end();
}

}  // namespace csgsim::read
