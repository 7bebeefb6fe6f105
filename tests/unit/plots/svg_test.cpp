#include "sim/plots/svg.h"

#include <cstring>
#include <pugixml.hpp>

#include "hw/base/text.h"
#include "sim/plots/layout.h"
#include "sim/plots/text_size.h"
#include "tests/support/test.h"
#include "tests/unit/plots/sample_plots.h"

using namespace csgsim;
namespace samples = csgsim::testing::plots_;

namespace {

/// Approximate to a hundredth of a pixel.
doctest::Approx about(double value) { return doctest::Approx(value).epsilon(1e-5).scale(1000); }

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(svg.data(), svg.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  CHECK_MESSAGE(result, result.description());
  return document;
}

/// Returns the child elements of a node.
std::vector<pugi::xml_node> child_elements(const pugi::xml_node& node) {
  std::vector<pugi::xml_node> elements;
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element) elements.push_back(child);
  }
  return elements;
}

/// Returns the SVG's groups for fills, lines, marks and texts, in this order.
std::vector<pugi::xml_node> groups_of(const pugi::xml_document& document) {
  std::vector<pugi::xml_node> all = child_elements(document.child("svg"));
  REQUIRE(all.size() == 5);
  CHECK(all.front().name() == std::string("rect"));
  return {all.begin() + 1, all.end()};
}

/// Returns the shape, which is in a group with a title if it has a tip; checks that tip.
pugi::xml_node shape_of(const pugi::xml_node& node, const std::string& tip) {
  if (tip.empty()) return node;
  CHECK(node.attribute("class").value() == std::string("pt"));
  CHECK(node.child_value("title") == printable(tip));
  return node.last_child();
}

std::vector<plots::Pixel> points_of(const pugi::xml_node& path) {
  std::string numbers = path.attribute("d").value();
  for (char& c : numbers) c = std::strchr("MLZ", c) != nullptr ? ' ' : c;
  std::istringstream in(numbers);
  std::vector<plots::Pixel> points;
  for (plots::Pixel one; in >> one.x >> one.y;) points.push_back(one);
  return points;
}

void check_fill(const pugi::xml_node& rect, const plots::Fill& fill) {
  CHECK(rect.attribute("x").as_double() == about(fill.box.left));
  CHECK(rect.attribute("y").as_double() == about(fill.box.top));
  CHECK(rect.attribute("width").as_double() == about(fill.box.right - fill.box.left));
  CHECK(rect.attribute("height").as_double() == about(fill.box.bottom - fill.box.top));
  CHECK(rect.attribute("fill").value() == fill.colour);
}

void check_line(const pugi::xml_node& path, const plots::Line& line) {
  const std::vector<plots::Pixel> points = points_of(path);
  REQUIRE(points.size() == line.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(points[i].x == about(line.points[i].x));
    CHECK(points[i].y == about(line.points[i].y));
  }
  CHECK(path.attribute("stroke").value() == line.colour);
  CHECK(path.attribute("stroke-width").as_double(1) == line.width);
  CHECK(path.attribute("stroke-dasharray").empty() == line.dash.empty());
}

/// Checks a mark: circles are around its middle, other forms have corners around it, none much farther than half the
/// size.
void check_mark(const pugi::xml_node& shape, const plots::Mark& mark) {
  if (shape.name() == std::string("circle")) {
    CHECK(shape.attribute("cx").as_double() == about(mark.at.x));
    CHECK(shape.attribute("cy").as_double() == about(mark.at.y));
    CHECK(shape.attribute("r").as_double() == about(mark.size / 2));
  } else {
    plots::Box box{1e9, 1e9, -1e9, -1e9};
    for (const plots::Pixel& corner : points_of(shape))
      box = {std::min(box.left, corner.x), std::min(box.top, corner.y), std::max(box.right, corner.x),
             std::max(box.bottom, corner.y)};
    CHECK(plots::is_within(plots::square_around(mark.at, 0.43 * mark.size), box));
    CHECK(plots::is_within(box, plots::square_around(mark.at, 0.68 * mark.size)));
  }
  const bool is_hollow = mark.form == plots::palette::Mark::ring || mark.form == plots::palette::Mark::box;
  CHECK(shape.attribute(is_hollow ? "stroke" : "fill").value() == mark.colour);
}

void check_text(const pugi::xml_node& node, const plots::Text& text) {
  CHECK(node.child_value() == text.text);
  CHECK(node.attribute("x").as_double() == about(text.at.x));
  // The baseline: capitals are centred half their height above it.
  CHECK(node.attribute("y").as_double() == about(text.at.y + 0.325 * plots::font_size));
  const char* const anchor = text.anchor == plots::Anchor::left     ? "start"
                             : text.anchor == plots::Anchor::centre ? "middle"
                                                                    : "end";
  CHECK(node.attribute("text-anchor").value() == std::string(anchor));
  CHECK(node.attribute("transform").empty() == !text.is_upright);
  CHECK(node.attribute("fill").value() == text.colour);
}

void check_all(const plots::Drawing& drawing) {
  const pugi::xml_document document = parsed(plots::svg_file(drawing));
  const std::vector<pugi::xml_node> groups = groups_of(document);
  const auto check = [](const pugi::xml_node& group, const auto& items, auto check_one) {
    const std::vector<pugi::xml_node> nodes = child_elements(group);
    REQUIRE(nodes.size() == items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      if constexpr (requires { items[i].tip; })
        check_one(shape_of(nodes[i], items[i].tip), items[i]);
      else
        check_one(nodes[i], items[i]);
    }
  };
  check(groups[0], drawing.fills, check_fill);
  check(groups[1], drawing.lines, check_line);
  check(groups[2], drawing.marks, check_mark);
  check(groups[3], drawing.texts, check_text);
}

}  // namespace

TEST_CASE("an SVG has all elements of a drawing in order with their positions and colours") {
  for (const plots::Plot& plot : samples::sample_plots()) {
    CAPTURE(plot.name);
    check_all(plots::lay_out(plot));
  }
  for (unsigned seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    check_all(plots::lay_out(samples::random_chart(random)));
    check_all(plots::lay_out(samples::random_bars(random)));
  }
}

TEST_CASE("an SVG file and an SVG element of a drawing differ only in their first line") {
  for (const plots::Plot& plot : samples::sample_plots()) {
    const plots::Drawing drawing = plots::lay_out(plot);
    const std::string file = plots::svg_file(drawing);
    CHECK(file == plots::svg_file(plots::lay_out(plot)));
    const std::string element = plots::svg_element(drawing, "class=\"plot\"");
    CHECK(element.substr(element.find('\n')) == file.substr(file.find('\n')));
  }
}

TEST_CASE("an SVG file has the drawing's size and a white background and the font size") {
  const pugi::xml_document document = parsed(plots::svg_file({321, 234, {}, {}, {}, {}}));
  const pugi::xml_node svg = document.child("svg");
  CHECK(svg.attribute("viewBox").value() == std::string("0 0 321 234"));
  CHECK(svg.attribute("width").as_int() == 321);
  CHECK(svg.attribute("height").as_int() == 234);
  CHECK(svg.first_child().attribute("fill").value() == std::string("#ffffff"));
  CHECK(svg.last_child().attribute("font-size").as_double() == plots::font_size);
}

TEST_CASE("an SVG's texts and tips of any bytes are escaped and valid XML") {
  const std::string hostile = "</text><script>alert(1)</script>\"'&amp;]]>\x01\n\xff\xfe\ufffe\uffff\u202e<!-- \\";
  plots::Drawing drawing{100, 100, {}, {}, {}, {}};
  drawing.texts.push_back({hostile, {50, 50}});
  drawing.marks.push_back({{50, 50}, plots::palette::Mark::disc, "#000000", 9, hostile});
  const std::string svg = plots::svg_file(drawing);
  for (const char* part : {"<script", "<!--", "]]>", "\x01", "\xff", "\ufffe", "\uffff", "\u202e"})
    CHECK(svg.find(part) == std::string::npos);
  const pugi::xml_document document = parsed(svg);
  const std::vector<pugi::xml_node> groups = groups_of(document);
  const std::string shown =
      "</text><script>alert(1)</script>\"'&amp;]]>\\x01\\n\\xff\\xfe\ufffd\ufffd\\xe2\\x80\\xae<!-- \\";
  CHECK(groups[3].first_child().child_value() == shown);
  CHECK(groups[2].first_child().child_value("title") == shown);
}

TEST_CASE("each mark has its own SVG form and dash lengths in half pixels become pixels") {
  std::set<std::string> forms;
  plots::Drawing drawing{100, 100, {}, {}, {}, {}};
  for (const plots::palette::Look& look : plots::palette::looks) {
    drawing.marks = {{{50, 50}, look.mark, "#000000"}};
    forms.insert(plots::svg_file(drawing));
  }
  CHECK(forms.size() == plots::palette::looks.size());
  drawing.lines = {{{{0, 0}, {9, 9}}, "#000000", 2, "8,5"}};
  CHECK(plots::svg_file(drawing).find("stroke-dasharray=\"4 2.5\"") != std::string::npos);
}
