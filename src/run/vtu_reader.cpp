#include <algorithm>
#include <bit>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <charconv>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>

#include "turgor/base/errors.hpp"
#include "turgor/run/vtu.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

/// The bytes, padding included; nothing for another text.
std::string bytes_of(std::string text) {
  using namespace boost::archive::iterators;
  using Decoder = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  if (text.empty() || text.size() % 4 != 0) return {};
  std::ranges::replace(text, '=', 'A');
  try {
    return {Decoder(text.cbegin()), Decoder(text.cend())};
  } catch (const dataflow_exception&) {
    return {};
  }
}

template <class Number>
constexpr const char* vtk_name = nullptr;
template <>
constexpr const char* vtk_name<double> = "Float64";
template <>
constexpr const char* vtk_name<std::int32_t> = "Int32";
template <>
constexpr const char* vtk_name<std::uint8_t> = "UInt8";

/// One of VTK's XML files.
class XmlFile {
 public:
  /// @param type  of the document: "UnstructuredGrid"
  XmlFile(fs::path path, const std::string& type) : path_(std::move(path)) {
    const pugi::xml_parse_result parsed = document_.load_file(path_.c_str());
    if (parsed.status == pugi::status_file_not_found || parsed.status == pugi::status_io_error) {
      refuse("cannot be read");
    }
    if (!parsed) {
      refuse(std::string("is no whole XML document: ") + parsed.description() + " at byte " +
             std::to_string(parsed.offset));
    }
    root_ = document_.child("VTKFile");
    if (root_.attribute("type").value() != type) refuse("is no VTK file of type " + type);
    root_ = root_.child(type.c_str());
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InvalidInput("", path_.string(), problem, "only files that turgor has written can be read");
  }

  [[nodiscard]] pugi::xml_node root() const { return root_; }

  /// Refuses what decides how the numbers of another program are to be read.
  void require_layout() const {
    const pugi::xml_node file = root_.parent();
    const char* own = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    require(file, "byte_order", own);
    require(file, "header_type", "UInt64");
    require(file, "compressor", "");
  }

  /// The numbers of a <DataArray>.
  /// @param count  that there must be
  template <class Number>
  [[nodiscard]] std::vector<Number> numbers(pugi::xml_node array, std::size_t count) const {
    std::vector<Number> all = numbers<Number>(array);
    if (all.size() != count) {
      refuse(in(array) + "has " + std::to_string(all.size()) + " numbers, where there should be " +
             std::to_string(count));
    }
    return all;
  }
  template <class Number>
  [[nodiscard]] std::vector<Number> numbers(pugi::xml_node array) const {
    if (!array) refuse("has an array too few");
    require(array, "type", vtk_name<Number>);
    require(array, "format", "binary");
    const std::string bytes = bytes_of(array.text().get());
    std::uint64_t size = 0;
    if (bytes.size() < sizeof size) refuse(in(array) + "is no base64");
    std::memcpy(&size, bytes.data(), sizeof size);
    if (size > bytes.size() - sizeof size || size % sizeof(Number) != 0) refuse(in(array) + "is cut off");
    std::vector<Number> all(size / sizeof(Number));
    std::memcpy(all.data(), bytes.data() + sizeof size, size);
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::ranges::all_of(all, [](Number x) { return std::isfinite(x); })) {
        refuse(in(array) + "has a number that is not finite");
      }
    }
    return all;
  }

 private:
  void require(pugi::xml_node node, const char* attribute, const std::string& value) const {
    const std::string given = node.attribute(attribute).value();
    if (given == value) return;
    refuse(std::string(node.name()) + " has " + attribute + " = \"" + given + "\", where turgor writes \"" + value +
           "\"");
  }

  static std::string in(pugi::xml_node array) {
    const std::string name = array.attribute("Name").value();
    return "the array \"" + (name.empty() ? std::string(array.parent().name()) : name) + "\" ";
  }

  fs::path path_;
  pugi::xml_document document_;
  pugi::xml_node root_;
};

template <std::size_t nodes>
void add_cell(std::vector<std::array<std::int32_t, nodes>>& cells, const std::int32_t* first) {
  auto& cell = cells.emplace_back();
  std::copy_n(first, nodes, cell.begin());
}

void read_cells(const XmlFile& file, pugi::xml_node piece, VtuGrid& grid) {
  constexpr std::uint8_t quadrilateral = 9;  // VTK_QUAD
  constexpr std::uint8_t biquadratic = 28;   // VTK_BIQUADRATIC_QUAD
  const pugi::xml_node cells = piece.child("Cells");
  const auto array = [&](const char* name) { return cells.find_child_by_attribute("DataArray", "Name", name); };
  const auto nodes = file.numbers<std::int32_t>(array("connectivity"));
  const auto types = file.numbers<std::uint8_t>(array("types"));
  const auto ends = file.numbers<std::int32_t>(array("offsets"), types.size());
  const auto points = static_cast<std::int32_t>(grid.points.size() / 3);
  if (!std::ranges::all_of(nodes, [&](std::int32_t i) { return i >= 0 && i < points; })) {
    file.refuse("has cells of points that there are not");
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] != quadrilateral && types[i] != biquadratic) {
      file.refuse("has cells of VTK's type " + std::to_string(types[i]));
    }
    const std::size_t end = begin + (types[i] == biquadratic ? 9 : 4);
    if (end > nodes.size() || !std::cmp_equal(ends[i], end)) file.refuse("has cells of a wrong number of points");
    if (types[i] == biquadratic) {
      add_cell(grid.biquadratic, &nodes[begin]);
    } else {
      add_cell(grid.quadrilaterals, &nodes[begin]);
    }
    begin = end;
  }
}

}  // namespace

VtuGrid read_vtu(const fs::path& path) {
  const XmlFile file(path, "UnstructuredGrid");
  file.require_layout();
  const pugi::xml_node piece = file.root().child("Piece");
  VtuGrid grid;
  grid.points = file.numbers<double>(piece.child("Points").child("DataArray"));
  if (grid.points.empty() || grid.points.size() % 3 != 0) file.refuse("has no points of three coordinates");
  read_cells(file, piece, grid);
  for (const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
    const int components = array.attribute("NumberOfComponents").as_int(1);
    if (components < 1) file.refuse("has point data of " + std::to_string(components) + " components");
    const std::size_t count = grid.points.size() / 3 * static_cast<std::size_t>(components);
    grid.data.push_back({array.attribute("Name").value(), components, file.numbers<double>(array, count)});
  }
  return grid;
}

std::vector<VtuInstant> read_pvd(const fs::path& path) {
  const XmlFile file(path, "Collection");
  std::vector<VtuInstant> series;
  for (const pugi::xml_node entry : file.root().children("DataSet")) {
    const std::string time = entry.attribute("timestep").value();
    VtuInstant instant{0, entry.attribute("file").value()};
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), instant.time);
    if (error != std::errc{} || end != time.data() + time.size() || !std::isfinite(instant.time)) {
      file.refuse("has the time \"" + time + "\", which is no number");
    }
    series.push_back(std::move(instant));
  }
  return series;
}

}  // namespace turgor
