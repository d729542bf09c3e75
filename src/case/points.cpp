#include "points.hpp"

#include "csv_table.hpp"

namespace turgor {

namespace {

/// "row 4: " for an issue about "material.table.stretch[2]": the header is row 1.
std::string row_of(const std::string& key) {
  const std::size_t at = key.find('[');
  return at == std::string::npos ? "" : "row " + std::to_string(std::stoul(key.substr(at + 1)) + 2) + ": ";
}

Points points_of_file(Reader& reader, const Case& c, const PointKeys& keys, const std::string& file) {
  const auto unit = [&](const std::string& column) { return reader.find_key(keys.table + "." + column)->unit; };
  const auto columns = read_csv(c.file.parent_path() / file, {{unit(keys.columns[0])}, {unit(keys.columns[1])}});
  return {columns[0].values, columns[1].values};
}

std::optional<Points> points_of_lists(Reader& reader, const PointKeys& keys) {
  std::array<std::optional<std::vector<double>>, 2> lists;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string key = keys.table + "." + keys.columns[i];
    if (reader.node(key) == nullptr) {
      reader.complain(keys.table, "has no list " + key);
    } else {
      lists[i] = reader.list(key);
    }
  }
  if (!lists[0] || !lists[1]) return std::nullopt;
  return Points{*lists[0], *lists[1]};
}

}  // namespace

std::optional<Points> read_points(Reader& reader, const Case& c, const PointKeys& keys,
                                  const std::function<void(const Points&)>& use) {
  if (reader.node(keys.table)->as<Node::Table>() == nullptr) return std::nullopt;  // said by check_unknown
  const bool lists = reader.node(keys.table + "." + keys.columns[0]) != nullptr ||
                     reader.node(keys.table + "." + keys.columns[1]) != nullptr;
  const std::string file_key = keys.table + ".file";
  if (lists == (reader.node(file_key) != nullptr)) {
    reader.complain(keys.table, lists ? "has both a file and inline points" : "has no points", keys.forms);
    return std::nullopt;
  }
  const auto file = reader.text(file_key);
  if (!lists && !file) return std::nullopt;
  try {
    const std::optional<Points> points = file ? points_of_file(reader, c, keys, *file) : points_of_lists(reader, keys);
    if (points) use(*points);
    return points;
  } catch (const InvalidInput& error) {
    for (const Issue& issue : error.issues()) {
      if (!file && issue.key.starts_with(keys.table + ".")) {
        reader.complain(InvalidInput({issue}));
        continue;
      }
      reader.complain(file ? file_key : keys.table,
                      row_of(issue.key) + (issue.value.empty() ? issue.problem : issue.value + ": " + issue.problem),
                      issue.advice);
    }
  }
  return std::nullopt;
}

}  // namespace turgor
