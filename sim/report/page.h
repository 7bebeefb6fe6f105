#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/report/drawing.h"

namespace csgsim::report {

using Json = nlohmann::ordered_json;

/// How a number is shown.
enum class Show : std::uint8_t {
  plain,  ///< digits in groups; numbers with a fraction to four digits, and the exact value when pointed at
  share,  ///< of 1, as a percentage with a bar
};

/// A cell of a table: words, a number, or nothing.
struct Cell {
  Json value;
  std::string at{};  ///< JSON pointer of the value in the page's data; empty for what the data do not hold
  Show show = Show::plain;
};

/// The value at a pointer of the data, or an empty cell where there is none.
Cell cell(const Json& data, const std::string& at, Show show = Show::plain);

/// The JSON pointer of a member of what stands at another.
std::string child(const std::string& at, const std::string& key);

/// Two whole numbers as a share; nothing of nothing is 0.
Cell share(const Json& part, double whole);

using Row = std::vector<Cell>;

/// The first cell of each row is the row's header.
struct Table {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  bool is_list = false;  ///< of keys and values of all kinds, which stand at the left
};

struct Paragraph {
  std::string text;
};

/// A PNG file, with what somebody is told who does not see it.
struct Picture {
  std::string caption;
  std::string alt;
  std::string png;
  std::uint32_t width = 0;   ///< pixels
  std::uint32_t height = 0;  ///< pixels
};

/// Pictures beside each other.
struct Gallery {
  std::vector<Picture> pictures;
};

/// A picture and whose surface each pixel of it shows. Rows of the table are primitives; whoever points at a pixel is
/// shown the row of its primitive.
struct OwnerPicture {
  Picture picture;
  Picture owners;
  std::vector<std::uint32_t> owner;      ///< of each pixel in row order: a primitive, or no_owner
  std::vector<std::uint32_t> primitive;  ///< of each row of the table
  Table prices;
};

using Part = std::variant<Paragraph, Table, plots::Plot, Gallery, OwnerPicture, Drawing>;

struct Section {
  std::string title;
  std::vector<Part> parts;
};

/// A page: all that its reader is shown, in order.
struct Page {
  std::string title;
  std::string command;  ///< that makes the page again, for a POSIX shell
  Json data;            ///< the numbers of the run, without those that differ from run to run
  std::vector<Section> sections;
};

/// The data of a run or study without the times that the simulation took here, which differ from run to run.
Json without_wall_times(Json data);

/// One HTML file that asks for nothing else. The same page gives the same bytes, whatever bytes its texts hold.
std::string to_html(const Page& page);

}  // namespace csgsim::report
