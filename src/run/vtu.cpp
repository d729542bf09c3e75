#include "vtu.hpp"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstring>
#include <pugixml.hpp>
#include <sstream>

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

void add_cells(pugi::xml_node piece, const VtuGrid& grid) {
  constexpr std::uint8_t quadrilateral = 9;  // VTK_QUAD
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> offsets;
  for (const auto& corners : grid.quadrilaterals) {
    connectivity.insert(connectivity.end(), corners.begin(), corners.end());
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
  }
  const pugi::xml_node cells = piece.append_child("Cells");
  add_array(cells, "Int32", "connectivity", 1, connectivity);
  add_array(cells, "Int32", "offsets", 1, offsets);
  add_array(cells, "UInt8", "types", 1, std::vector<std::uint8_t>(offsets.size(), quadrilateral));
}

}  // namespace

std::string vtu_text(const VtuGrid& grid) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "UnstructuredGrid";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  file.append_attribute("header_type") = "UInt64";
  pugi::xml_node piece = file.append_child("UnstructuredGrid").append_child("Piece");
  piece.append_attribute("NumberOfPoints") = static_cast<unsigned>(grid.points.size() / 3);
  piece.append_attribute("NumberOfCells") = static_cast<unsigned>(grid.quadrilaterals.size());
  add_array(piece.append_child("Points"), "Float64", "", 3, grid.points);
  add_cells(piece, grid);
  pugi::xml_node data = piece.append_child("PointData");
  data.append_attribute("Scalars") = grid.data.front().name.c_str();
  for (const PointData& quantity : grid.data) {
    add_array(data, "Float64", quantity.name, quantity.components, quantity.values);
  }
  std::ostringstream text;
  document.save(text, "", pugi::format_raw);
  return text.str();
}

}  // namespace turgor
