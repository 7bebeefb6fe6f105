// Structure of an HTML page: sections, tables, pictures.
// Used by sim/report, sim/session and sim/studies.
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

/// Display format of a number.
enum class Show : std::uint8_t {
  plain,  ///< digits in groups; fractions to four digits, with the exact value in a tooltip
  share,  ///< a fraction of 1, as a percentage with a bar
};

/// A cell of a table: words, a number, or nothing.
struct Cell {
  Json value;
  std::string at{};  ///< JSON pointer of the value in the page's data; empty if the data do not contain it
  Show show = Show::plain;
};

/// A cell with the value of `data` at a JSON pointer; an empty cell if there is none.
Cell cell(const Json& data, const std::string& pointer, Show show = Show::plain);

/// The JSON pointer of the member `key` of the value at `pointer`.
std::string child_pointer(const std::string& pointer, const std::string& key);

/// The quotient of two numbers as a share; 0 if the whole is 0.
Cell share(const Json& part, double whole);

using Row = std::vector<Cell>;

/// A table; the first cell of each row is the row's header.
struct Table {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  bool is_list = false;  ///< keys and values of all kinds, aligned left
};

struct Paragraph {
  std::string text;
};

/// A PNG file with a text alternative.
struct Picture {
  std::string caption;
  std::string alt;
  std::string png;
  std::uint32_t width = 0;   ///< pixels
  std::uint32_t height = 0;  ///< pixels
};

/// Pictures side by side.
struct Gallery {
  std::vector<Picture> pictures;
};

/// A picture and the owner of each of its pixels. The rows of the table are primitives; selecting a pixel highlights
/// the row of its primitive.
struct OwnerPicture {
  Picture picture;
  Picture owners;
  std::vector<std::uint32_t> owner;      ///< owner of each pixel in row order: a primitive, or no_owner
  std::vector<std::uint32_t> primitive;  ///< primitive of each row of the table
  Table prices;
};

using Part = std::variant<Paragraph, Table, plots::Plot, Gallery, OwnerPicture, Drawing>;

struct Section {
  std::string title;
  std::vector<Part> parts;
};

/// A page: its contents in order.
struct Page {
  std::string title;
  std::string command;  ///< command that generates the page again, for a POSIX shell
  Json data;            ///< the numbers of the run, without those that differ from run to run
  std::vector<Section> sections;
};

/// The data of a run or study without wall times, which differ from run to run.
Json without_wall_times(Json data);

/// One self-contained HTML file. Equal pages give equal bytes, whatever bytes the texts contain.
std::string to_html(const Page& page);

}  // namespace csgsim::report
