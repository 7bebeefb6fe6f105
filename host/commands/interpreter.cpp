#include "host/commands/interpreter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <map>
#include <variant>

#include "host/commands/expression.h"
#include "host/commands/shapes.h"
#include "host/model/degrees.h"
#include "host/read/limits.h"

namespace csgsim::commands {

namespace {

constexpr double usual_tolerance = 0.1;

class Interpreter {
 public:
  explicit Interpreter(read::Source& source) : source_(source) {}

  Model run() {
    for (const std::vector<Item>& items : split_lines(source_)) {
      Cursor line(source_, items);
      execute(line);
      line.end();
    }
    for (const std::string_view name : {std::string_view("Object"), last_}) {
      const auto found = names_.find(name);
      const auto* const solid = found == names_.end() ? nullptr : std::get_if<SolidName>(&found->second);
      if (solid != nullptr && model_.drawn == nothing) model_.drawn = solid->solid;
    }
    return std::move(model_);
  }

 private:
  struct SolidName {
    std::uint32_t solid;
  };
  struct PatchName {};
  using Named = std::variant<SolidName, Curve, PatchName>;

  struct CommandRow {
    std::string_view word;
    void (Interpreter::*act)(Cursor& line);
  };
  static constexpr std::array<CommandRow, 6> commands();

  void execute(Cursor& line);
  void define(const Item& name, Cursor& line);
  void move(Cursor& line);
  void rotate(Cursor& line);
  void scale(Cursor& line);
  void colour(Cursor& line);
  void set_facets(Cursor& line);
  void set_tolerance(Cursor& line) { tolerance_ = line.take_positive_number("a tolerance in model units"); }

  std::uint32_t add(Solid solid, std::uint32_t offset);
  SolidName& solid_named(const Item& name);
  const Curve& curve_named(Cursor& line, std::string_view use, std::size_t fewest, std::size_t most);
  void place(SolidName& solid, const glm::dmat4& matrix, std::uint32_t offset);
  std::uint32_t add_sweep(const Item& name, Cursor& line);
  void add_patch(const Item& name, Cursor& line);

  read::Source& source_;
  Model model_;
  std::map<std::string_view, Named> names_;
  std::string_view last_;  ///< the last name to which a line assigned a solid
  model::FacetControl facets_;
  double tolerance_ = usual_tolerance;
};

constexpr std::array<Interpreter::CommandRow, 6> Interpreter::commands() {
  return {CommandRow{"move", &Interpreter::move},         CommandRow{"rotate", &Interpreter::rotate},
          CommandRow{"scale", &Interpreter::scale},       CommandRow{"colour", &Interpreter::colour},
          CommandRow{"facets", &Interpreter::set_facets}, CommandRow{"tolerance", &Interpreter::set_tolerance}};
}

constexpr std::string_view command_forms =
    "a line is `NAME = ...`, or move, rotate, scale, colour, facets or tolerance with arguments";

int axis_index(const Item& item) {
  if (item.is("x")) return 0;
  if (item.is("y")) return 1;
  return item.is("z") ? 2 : 3;
}

/// Numbers along x, y and z, in this order, or each after the letter of its axis.
struct AlongAxes {
  glm::dvec3 values;
  std::size_t numbers = 0;  ///< count of numbers without letters
};

AlongAxes read_along_axes(Cursor& line, double usual) {
  AlongAxes found{glm::dvec3(usual)};
  if (!line.is(Kind::word)) {
    const std::uint32_t offset = line.offset();
    const std::vector<double> numbers = line.numbers();
    if (numbers.empty()) line.fail_here("expected numbers, or x, y or z with a number");
    if (numbers.size() > 3) line.fail(offset, "there are three axes; remove the extra numbers");
    for (std::size_t i = 0; i < numbers.size(); ++i) found.values[static_cast<int>(i)] = numbers[i];
    found.numbers = numbers.size();
    return found;
  }
  while (line.is(Kind::word)) {
    const Item& letter = line.take();
    const int axis = axis_index(letter);
    if (axis > 2) line.fail(letter.offset, fmt::format("expected x, y or z, found `{}`", read::shown(letter.text)));
    found.values[axis] = line.number("a number after the axis");
  }
  return found;
}

void Interpreter::execute(Cursor& line) {
  const Item& first = line.word(command_forms);
  if (line.take_if("=")) return define(first, line);
  static constexpr auto rows = commands();
  const auto row = std::ranges::find(rows, first.text, &CommandRow::word);
  if (row == rows.end())
    line.fail(first.offset, fmt::format("there is no command {}; {}", read::shown(first.text), command_forms));
  (this->*row->act)(line);
}

std::uint32_t Interpreter::add(Solid solid, std::uint32_t offset) {
  if (model_.solids.size() >= read::max_statements)
    source_.fail(offset, fmt::format("more than {} solids; split the model", read::max_statements));
  solid.location = source_.locate(offset);
  model_.solids.push_back(std::move(solid));
  return static_cast<std::uint32_t>(model_.solids.size() - 1);
}

void Interpreter::define(const Item& name, Cursor& line) {
  constexpr std::array<std::string_view, 3> others{"sweep", "curve", "patch"};
  if (is_solid_word(name.text) || std::ranges::find(others, name.text) != others.end())
    line.fail(name.offset, fmt::format("{} is a reserved word; choose another name", name.text));
  if (line.take_if("curve")) {
    names_.insert_or_assign(name.text, read_curve(line));
    return;
  }
  if (line.take_if("patch")) {
    add_patch(name, line);
    names_.insert_or_assign(name.text, PatchName{});
    return;
  }
  std::uint32_t solid = nothing;
  if (line.take_if("sweep")) {
    solid = add_sweep(name, line);
  } else if (line.is(Kind::word) && is_solid_word(line.peek().text)) {
    const Item& word = line.take();
    solid = add({read_solid(word.text, line, facets_), {}}, name.offset);
  } else {
    const Algebra algebra{[&](const Item& one) { return solid_named(one).solid; },
                          [&](model::Operator op, std::uint32_t left, std::uint32_t right, const Item& sign) {
                            return add({CombinedSolid{op, left, right}, {}}, sign.offset);
                          }};
    solid = read_expression(line, algebra);
  }
  names_.insert_or_assign(name.text, SolidName{solid});
  last_ = name.text;
}

Interpreter::SolidName& Interpreter::solid_named(const Item& name) {
  const auto found = names_.find(name.text);
  if (found == names_.end()) {
    const std::string_view meant = similar_solid_word(name.text);
    source_.fail(name.offset, fmt::format("{0} is not defined before this line; {1}", read::shown(name.text),
                                          meant.empty() ? fmt::format("write `{} = ...` above", read::shown(name.text))
                                                        : fmt::format("did you mean {}?", meant)));
  }
  if (std::holds_alternative<Curve>(found->second))
    source_.fail(name.offset,
                 fmt::format("{} is a curve, not a solid; make a solid with a sweep", read::shown(name.text)));
  if (std::holds_alternative<PatchName>(found->second))
    source_.fail(name.offset,
                 fmt::format("{} is a patch, not a solid; csgsim mesh accepts it", read::shown(name.text)));
  return std::get<SolidName>(found->second);
}

void Interpreter::place(SolidName& solid, const glm::dmat4& matrix, std::uint32_t offset) {
  solid.solid = add({MovedSolid{matrix, solid.solid}, {}}, offset);
}

void Interpreter::move(Cursor& line) {
  const Item& name = line.word("the name of a solid");
  SolidName& solid = solid_named(name);
  place(solid, glm::translate(glm::dmat4(1), read_along_axes(line, 0).values), name.offset);
}

void Interpreter::scale(Cursor& line) {
  const Item& name = line.word("the name of a solid");
  SolidName& solid = solid_named(name);
  const std::uint32_t offset = line.offset();
  AlongAxes by = read_along_axes(line, 1);
  if (by.numbers == 1) by.values = glm::dvec3(by.values.x);
  if (by.values.x == 0 || by.values.y == 0 || by.values.z == 0)
    line.fail(offset, "a scale of 0 removes the solid; use another number");
  place(solid, glm::scale(glm::dmat4(1), by.values), name.offset);
}

void Interpreter::rotate(Cursor& line) {
  const Item& name = line.word("the name of a solid");
  SolidName& solid = solid_named(name);
  if (line.at_end()) line.fail_here("expected x, y or z and degrees");
  while (!line.at_end()) {
    const Item& letter = line.word("x, y or z");
    const int axis = axis_index(letter);
    if (axis > 2) line.fail(letter.offset, fmt::format("expected x, y or z, found `{}`", read::shown(letter.text)));
    const double degrees = line.number("degrees");
    const double cosine = model::cos_degrees(degrees);
    const double sine = model::sin_degrees(degrees);
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    glm::dmat4 matrix(1);
    matrix[next][next] = cosine;
    matrix[next][last] = sine;
    matrix[last][next] = -sine;
    matrix[last][last] = cosine;
    place(solid, matrix, name.offset);
  }
}

void Interpreter::colour(Cursor& line) {
  const Item& name = line.word("the name of a solid");
  SolidName& solid = solid_named(name);
  const std::uint32_t offset = line.offset();
  const std::vector<double> numbers = line.numbers();
  if (numbers.size() != 3 || std::ranges::any_of(numbers, [](double one) { return one < 0 || one > 1; }))
    line.fail(offset, "a colour must be red, green and blue, each from 0 to 1");
  solid.solid = add({ColouredSolid{{numbers[0], numbers[1], numbers[2]}, solid.solid}, {}}, name.offset);
}

void Interpreter::set_facets(Cursor& line) {
  const std::uint32_t offset = line.offset();
  const double count = line.number("the number of facets of a circle");
  constexpr double most = 100'000;
  if (!(count >= 3 && count <= most && count == std::floor(count)))
    line.fail(offset, fmt::format("a circle must have 3 to {} facets", most));
  facets_.fn = count;
}

const Curve& Interpreter::curve_named(Cursor& line, std::string_view use, std::size_t fewest, std::size_t most) {
  const Item& name = line.word("the name of a curve");
  const auto found = names_.find(name.text);
  const auto* const curve = found == names_.end() ? nullptr : std::get_if<Curve>(&found->second);
  if (curve == nullptr)
    line.fail(name.offset, fmt::format("there is no curve {0} before this line; write `{0} = curve ...` above",
                                       read::shown(name.text)));
  if (curve->numbers < fewest || curve->numbers > most)
    line.fail(name.offset, fmt::format("the points of a {} must have {} numbers, but those of {} have {}", use,
                                       fewest == most ? fmt::format("{}", most) : fmt::format("{} or {}", fewest, most),
                                       read::shown(name.text), curve->numbers));
  return *curve;
}

std::uint32_t Interpreter::add_sweep(const Item& name, Cursor& line) {
  SweptSolid made{name.text, name.offset, {}, tolerance_};
  bool has_contour = false;
  bool has_trajectory = false;
  while (!line.at_end()) {
    if (line.take_if("contour")) {
      made.sweep.contour = curve_named(line, "contour", 2, 2).curve;
      has_contour = true;
    } else if (line.take_if("trajectory")) {
      made.sweep.trajectory = curve_named(line, "trajectory", 3, 3).curve;
      has_trajectory = true;
    } else if (line.take_if("rotation")) {
      made.sweep.rotation = curve_named(line, "rotation", 1, 1).curve;
    } else if (line.take_if("scale")) {
      const Curve& curve = curve_named(line, "scale", 1, 2);
      made.sweep.scale = curve.curve;
      for (glm::dvec3& point : made.sweep.scale.points) point.y = curve.numbers == 1 ? point.x : point.y;
    } else if (line.take_if("tolerance")) {
      made.tolerance = line.take_positive_number("a tolerance in model units");
    } else {
      line.fail_here("expected contour, trajectory, rotation, scale or tolerance");
    }
  }
  if (!has_contour || !has_trajectory)
    line.fail(name.offset,
              fmt::format("a sweep needs a contour and a trajectory: {} = sweep contour CURVE trajectory CURVE",
                          read::shown(name.text)));
  if (const std::string fault = swept::validation_error(made.sweep); !fault.empty()) line.fail(name.offset, fault);
  model_.sweeps.push_back(std::move(made));
  return add({Swept{static_cast<std::uint32_t>(model_.sweeps.size() - 1)}, {}}, name.offset);
}

void Interpreter::add_patch(const Item& name, Cursor& line) {
  Patch made{name.text, name.offset, read_net(line), tolerance_};
  if (line.take_if("tolerance")) made.tolerance = line.take_positive_number("a tolerance in model units");
  model_.patches.push_back(std::move(made));
}

}  // namespace

Model interpret(read::Source& source) { return Interpreter(source).run(); }

}  // namespace csgsim::commands
