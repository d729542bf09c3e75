#include "csv_table.hpp"

#include <csv.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>

#include "turgor/base/errors.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

using Rows = std::vector<std::vector<std::string>>;

struct Parsed {
  Rows rows;
  bool cut;  ///< the last line has no end
};

InvalidInput wrong(const std::filesystem::path& file, std::size_t row, std::string problem, std::string advice = {}) {
  const std::string where = file.string() + (row > 0 ? ", row " + std::to_string(row) : "");
  return InvalidInput("", where, std::move(problem), std::move(advice));
}

Parsed parse_rows(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw wrong(file, 0, "cannot be read", "in a case, file names are relative to the case file's folder");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) throw wrong(file, 0, "cannot be read");

  struct State {
    Rows rows;
    std::vector<std::string> row;
  } state;
  csv_parser parser{};
  if (csv_init(&parser, CSV_APPEND_NULL) != 0) throw ComputationFailed("the CSV parser could not be started");
  const std::unique_ptr<csv_parser, void (*)(csv_parser*)> guard(&parser, csv_free);
  const auto on_field = [](void* field, std::size_t size, void* data) {
    static_cast<State*>(data)->row.emplace_back(static_cast<const char*>(field), size);
  };
  const auto on_row = [](int, void* data) {
    auto* s = static_cast<State*>(data);
    s->rows.push_back(std::move(s->row));
    s->row.clear();
  };
  if (csv_parse(&parser, text.data(), text.size(), on_field, on_row, &state) != text.size()) {
    throw wrong(file, state.rows.size() + 1, csv_strerror(csv_error(&parser)));
  }
  csv_fini(&parser, on_field, on_row, &state);
  return {std::move(state.rows), !text.empty() && !text.ends_with('\n')};
}

/// What a header like "p [kPa]" says about its column.
struct Header {
  std::string unit;  ///< SI
  double factor;     ///< from the unit of the file
};

Header parse_header(const std::filesystem::path& file, const std::string& header,
                    const std::vector<std::string>& units) {
  const std::size_t open = header.find('[');
  const std::size_t close = header.find(']');
  if (open == std::string::npos || close == std::string::npos || close < open) {
    throw wrong(file, 1, "the header \"" + header + "\" has no unit",
                "write it like \"t [s]\" or \"p [kPa]\", with [1] for a number without unit");
  }
  const std::string given = header.substr(open + 1, close - open - 1);
  for (const std::string& unit : units) {
    if (given == unit) return {unit, 1};
  }
  Issue issue;
  for (const std::string& unit : units) {
    try {
      return {unit, unit_factor(given, unit)};
    } catch (const InvalidInput& error) {
      if (issue.problem.empty()) issue = error.issues().front();
    }
  }
  if (units.size() > 1) {
    issue.advice = "allowed are units of";
    for (const std::string& unit : units) issue.advice += (unit == units.front() ? " " : " or ") + unit;
  }
  throw wrong(file, 1, "in the header \"" + header + "\" " + issue.problem, issue.advice);
}

double parse_number(const std::filesystem::path& file, std::size_t row, const std::string& field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) {
    throw wrong(file, row, "\"" + field + "\" is not a finite number");
  }
  return value;
}

/// "force [N]" -> "force"
std::string name_in(const std::string& header) {
  const std::size_t open = header.find('[');
  const std::size_t end = header.find_last_not_of(' ', open == 0 || open == std::string::npos ? open : open - 1);
  return end == std::string::npos ? "" : header.substr(0, end + 1);
}

/// Where in a header a column stands.
std::size_t find_column(const std::filesystem::path& file, const std::vector<std::string>& header,
                        const std::string& name) {
  std::string names;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (name_in(header[i]) == name) return i;
    names += (names.empty() ? "" : ", ") + name_in(header[i]);
  }
  throw wrong(file, 1, "has no column " + name, names.empty() ? "" : "it has " + names);
}

}  // namespace

std::vector<CsvColumn> read_csv(const std::filesystem::path& file, const std::vector<std::vector<std::string>>& units) {
  const Rows rows = parse_rows(file).rows;
  if (rows.size() < 2) throw wrong(file, 0, "holds no rows of numbers", "give a header and at least two rows");
  std::vector<CsvColumn> columns(units.size());
  std::vector<double> factors;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].size() != units.size()) {
      throw wrong(file, r + 1, "has " + std::to_string(rows[r].size()) + " columns",
                  std::to_string(units.size()) + " are needed");
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
      const std::string& field = rows[r][i];
      if (r == 0) {
        const Header header = parse_header(file, field, units[i]);
        columns[i].unit = header.unit;
        factors.push_back(header.factor);
        continue;
      }
      columns[i].values.push_back(parse_number(file, r + 1, field) * factors[i]);
    }
  }
  return columns;
}

CsvExtract extract_csv(const std::filesystem::path& file, const std::vector<CsvName>& names) {
  auto [rows, cut] = parse_rows(file);
  if (cut) rows.pop_back();
  if (rows.empty()) throw wrong(file, 0, "has no line of column names");
  CsvExtract extract{std::vector<std::vector<double>>(names.size()), cut};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t at = find_column(file, rows[0], names[i].name);
    const double factor = parse_header(file, rows[0][at], {names[i].unit}).factor;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      if (rows[r].size() != rows[0].size()) {
        throw wrong(file, r + 1, "has " + std::to_string(rows[r].size()) + " columns",
                    "the first row names " + std::to_string(rows[0].size()));
      }
      extract.columns[i].push_back(parse_number(file, r + 1, rows[r][at]) * factor);
    }
  }
  return extract;
}

}  // namespace turgor
