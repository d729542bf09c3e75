#include "turgor/run/vtu.hpp"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstring>
#include <pugixml.hpp>
#include <sstream>

#include "turgor/base/text.hpp"

namespace turgor {

namespace {

std::string base64(std::string bytes) {
  using namespace boost::archive::iterators;
  using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string text(Encoder(bytes.begin()), Encoder(bytes.end()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

/// The number of bytes as an integer of 64 bits, then the numbers.
template <class Number>
std::string encoded(const std::vector<Number>& numbers) {
  const std::uint64_t size = numbers.size() * sizeof(Number);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
  return base64(std::move(bytes));
}

template <class Number>
void add_array(pugi::xml_node parent, const char* type, const std::string& name, int components,
               const std::vector<Number>& numbers) {
  pugi::xml_node array = parent.append_child("DataArray");
  array.append_attribute("type") = type;
  if (!name.empty()) array.append_attribute("Name") = name.c_str();
  if (components > 1) array.append_attribute("NumberOfComponents") = components;
  array.append_attribute("format") = "binary";
  array.text() = encoded(numbers).c_str();
}

/// The cells of every type that VTK knows by a number.
class Cells {
 public:
  template <std::size_t nodes>
  void add(std::uint8_t type, const std::vector<std::array<std::int32_t, nodes>>& cells) {
    for (const auto& cell : cells) {
      connectivity_.insert(connectivity_.end(), cell.begin(), cell.end());
      offsets_.push_back(static_cast<std::int32_t>(connectivity_.size()));
      types_.push_back(type);
    }
  }
  void write(pugi::xml_node piece) const {
    const pugi::xml_node cells = piece.append_child("Cells");
    add_array(cells, "Int32", "connectivity", 1, connectivity_);
    add_array(cells, "Int32", "offsets", 1, offsets_);
    add_array(cells, "UInt8", "types", 1, types_);
  }

 private:
  std::vector<std::int32_t> connectivity_;
  std::vector<std::int32_t> offsets_;
  std::vector<std::uint8_t> types_;
};

void add_cells(pugi::xml_node piece, const VtuGrid& grid) {
  constexpr std::uint8_t quadrilateral = 9;  // VTK_QUAD
  constexpr std::uint8_t biquadratic = 28;   // VTK_BIQUADRATIC_QUAD
  Cells cells;
  cells.add(quadrilateral, grid.quadrilaterals);
  cells.add(biquadratic, grid.biquadratic);
  cells.write(piece);
}

/// <VTKFile> of some type in a new document.
pugi::xml_node add_file(pugi::xml_document& document, const char* type) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = type;
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  file.append_attribute("header_type") = "UInt64";
  return file;
}

std::string text_of(const pugi::xml_document& document, const char* indent, unsigned format) {
  std::ostringstream text;
  document.save(text, indent, format);
  return text.str();
}

}  // namespace

std::string vtu_text(const VtuGrid& grid) {
  pugi::xml_document document;
  pugi::xml_node file = add_file(document, "UnstructuredGrid");
  pugi::xml_node piece = file.append_child("UnstructuredGrid").append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<unsigned>(grid.points.size() / 3);
  piece.append_attribute("NumberOfCells") = static_cast<unsigned>(grid.quadrilaterals.size() + grid.biquadratic.size());
  add_array(piece.append_child("Points"), "Float64", "", 3, grid.points);
  add_cells(piece, grid);
  pugi::xml_node data = piece.append_child("PointData");
  data.append_attribute("Scalars") = grid.data.front().name.c_str();
  for (const PointData& quantity : grid.data) {
    add_array(data, "Float64", quantity.name, quantity.components, quantity.values);
  }
  return text_of(document, "", pugi::format_raw);
}

std::string pvd_text(const std::vector<VtuInstant>& series) {
  pugi::xml_document document;
  pugi::xml_node collection = add_file(document, "Collection").append_child("Collection");
  for (const VtuInstant& instant : series) {
    pugi::xml_node entry = collection.append_child("DataSet");
    entry.append_attribute("timestep") = shortest(instant.time).c_str();
    entry.append_attribute("file") = instant.file.c_str();
  }
  return text_of(document, "  ", pugi::format_default);
}

}  // namespace turgor
