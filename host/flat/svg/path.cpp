#include "host/flat/svg/path.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "host/flat/svg/arc.h"
#include "host/flat/svg/numbers.h"
#include "host/model/degrees.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::flat::svg {

namespace {

constexpr std::uint32_t sides_per_curve = 20;
constexpr std::uint32_t corners_of_ellipses = 40;

/// A subpath is closed if its ends are closer than this.
constexpr double closed_within = 0.1;

/// Number of operands of a command; empty if the command is unknown.
std::optional<std::size_t> operands(char command) {
  switch (command) {
    case 'm':
    case 'l':
    case 't': return 2;
    case 'h':
    case 'v': return 1;
    case 'c': return 6;
    case 's':
    case 'q': return 4;
    case 'a': return 7;
    case 'z': return 0;
    default: return std::nullopt;
  }
}

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

enum class Curve { none, quadratic, cubic };

class Path {
 public:
  Path(const Stroke& stroke, std::size_t max_corners) : stroke_(stroke), max_corners_(max_corners) {}

  void act(char command, bool relative, std::span<const double> numbers);
  std::vector<Outline> finish();

 private:
  void move(const glm::dvec2& to);
  void close();
  void line(const glm::dvec2& to);
  void curve(char command, const glm::dvec2& base, std::span<const double> numbers);
  template <std::size_t Count>
  void draw_curve(Curve kind, const std::array<glm::dvec2, Count>& points);
  void end_subpath();
  void check_corners();

  Stroke stroke_;
  std::size_t max_corners_;
  std::vector<Outline> done_;
  Outline current_;
  glm::dvec2 at_{0};
  glm::dvec2 control_{0};  ///< last control point of the previous curve
  Curve last_ = Curve::none;
  bool any_closed_ = false;
  std::size_t corners_ = 0;
};

void Path::check_corners() {
  corners_ = 0;
  for (const Outline& outline : done_) corners_ += outline.size();
  if (corners_ > max_corners_)
    throw InputError("a path has more than " + std::to_string(max_corners_) + " corners; simplify it");
}

/// Finishes the current subpath. An open subpath becomes a line as wide as its stroke.
void Path::end_subpath() {
  if (current_.empty()) return;
  if (glm::distance(current_.front(), current_.back()) > closed_within) {
    for (Outline& outline : stroke_outlines(current_, stroke_, max_corners_)) done_.push_back(std::move(outline));
  } else {
    done_.push_back(std::move(current_));
  }
  current_.clear();
  check_corners();
}

void Path::move(const glm::dvec2& to) {
  end_subpath();
  current_.push_back(to);
  at_ = to;
}

void Path::close() {
  if (!current_.empty()) {
    at_ = current_.front();
    done_.push_back(std::move(current_));
    current_.clear();
    check_corners();
  }
  any_closed_ = true;
}

void Path::line(const glm::dvec2& to) {
  current_.push_back(to);
  at_ = to;
}

/// Adds a Bézier curve, by de Casteljau's algorithm.
template <std::size_t Count>
void Path::draw_curve(Curve kind, const std::array<glm::dvec2, Count>& points) {
  for (std::uint32_t side = 1; side <= sides_per_curve; ++side) {
    const double t = static_cast<double>(side) / sides_per_curve;
    std::array<glm::dvec2, Count> left = points;
    for (std::size_t count = Count - 1; count > 0; --count) {
      for (std::size_t i = 0; i < count; ++i) left[i] = left[i] * (1 - t) + left[i + 1] * t;
    }
    current_.push_back(left[0]);
  }
  control_ = points[Count - 2];
  at_ = points[Count - 1];
  last_ = kind;
}

void Path::curve(char command, const glm::dvec2& base, std::span<const double> numbers) {
  const auto point = [&](std::size_t i) { return base + glm::dvec2(numbers[2 * i], numbers[2 * i + 1]); };
  const Curve kind = command == 'c' || command == 's' ? Curve::cubic : Curve::quadratic;
  const glm::dvec2 mirrored = last_ == kind ? 2.0 * at_ - control_ : at_;
  if (command == 'c') draw_curve<4>(kind, {at_, point(0), point(1), point(2)});
  if (command == 's') draw_curve<4>(kind, {at_, mirrored, point(0), point(1)});
  if (command == 'q') draw_curve<3>(kind, {at_, point(0), point(1)});
  if (command == 't') draw_curve<3>(kind, {at_, mirrored, point(0)});
}

void Path::act(char command, bool relative, std::span<const double> numbers) {
  const glm::dvec2 base = relative ? at_ : glm::dvec2(0);
  switch (command) {
    case 'c':
    case 's':
    case 'q':
    case 't': curve(command, base, numbers); break;
    case 'm': move(base + glm::dvec2(numbers[0], numbers[1])); break;
    case 'l': line(base + glm::dvec2(numbers[0], numbers[1])); break;
    case 'h': line({base.x + numbers[0], at_.y}); break;
    case 'v': line({at_.x, base.y + numbers[0]}); break;
    case 'a': {
      const glm::dvec2 to = base + glm::dvec2(numbers[5], numbers[6]);
      add_arc(current_, {at_, to, {numbers[0], numbers[1]}, numbers[2], numbers[3] != 0, numbers[4] != 0});
      at_ = to;
      break;
    }
    default: close();
  }
  if (command != 'c' && command != 's' && command != 'q' && command != 't') last_ = Curve::none;
  if (current_.size() > max_corners_)
    throw InputError("a path has more than " + std::to_string(max_corners_) + " corners; simplify it");
}

std::vector<Outline> Path::finish() {
  if (any_closed_ && !current_.empty()) {
    done_.push_back(std::move(current_));
  } else {
    end_subpath();
  }
  return std::move(done_);
}

[[noreturn]] void fail(std::string_view rest) {
  constexpr std::size_t shown = 20;
  throw InputError("invalid path data at \"" + printable(rest.substr(0, shown)) + "\"; correct it");
}

/// Reads one set of a command's operands.
std::vector<double> read_operands(Numbers& rest, char command, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    rest.skip_separators();
    const bool is_flag = command == 'a' && (i == 3 || i == 4);
    const std::optional<double> number = is_flag ? std::optional<double>(rest.flag()) : rest.number();
    if (!number) fail(rest.rest());
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

std::vector<Outline> read_path(std::string_view data, const Stroke& stroke, std::size_t max_corners) {
  Path path(stroke, max_corners);
  Numbers rest(data);
  rest.skip_separators();
  while (!rest.at_end()) {
    const std::string_view here = rest.rest();
    const char letter = rest.letter().value_or(' ');
    char command = lower(letter);
    const std::optional<std::size_t> count = operands(command);
    if (!count) fail(here);
    do {
      path.act(command, letter == command || (letter == 'm' && command == 'l'), read_operands(rest, command, *count));
      if (command == 'm') command = 'l';
      rest.skip_separators();
    } while (*count > 0 && !rest.at_end() && Numbers(rest.rest()).number());
  }
  return path.finish();
}

Outline ellipse(const glm::dvec2& centre, const glm::dvec2& radii) {
  Outline outline;
  for (std::uint32_t i = 1; i <= corners_of_ellipses; ++i) {
    const double angle = 360.0 * i / corners_of_ellipses;
    outline.push_back(centre + radii * glm::dvec2(model::sin_degrees(angle), model::cos_degrees(angle)));
  }
  return outline;
}

Outline rounded_rectangle(const glm::dvec2& low, const glm::dvec2& size, const glm::dvec2& radii) {
  const glm::dvec2 high = low + size;
  const glm::dvec2 across(radii.x, 0);
  const glm::dvec2 along(0, radii.y);
  const std::array<glm::dvec2, 4> corners{{{high.x, low.y}, high, {low.x, high.y}, low}};
  Outline outline{low + across};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double x = i == 0 || i == 1 ? -1 : 1;
    const double y = i == 0 || i == 3 ? 1 : -1;
    const glm::dvec2 beside = corners[i] + x * across;
    const glm::dvec2 above = corners[i] + y * along;
    const bool first_beside = i % 2 == 0;
    const glm::dvec2& from = first_beside ? beside : above;
    const glm::dvec2& to = first_beside ? above : beside;
    outline.push_back(from);
    add_arc(outline, {from, to, radii, 0, false, true});
  }
  return outline;
}

}  // namespace csgsim::flat::svg
