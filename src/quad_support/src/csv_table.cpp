#include "quad_support/csv_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_support {
namespace {

std::vector<std::string> split(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string> cells;
  for (;;) {
    const auto comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    cells.emplace_back(cell);
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable CsvTable::parse(std::string_view text, const std::string& source) {
  CsvTable table;
  table.source_ = source;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets put it first
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    text.remove_prefix(kByteOrderMark.size());
  std::size_t line_number = 0;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line_number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto cells = split(line);
    if (table.columns_.empty()) {
      auto sorted = cells;
      std::sort(sorted.begin(), sorted.end());
      const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
      if (twice != sorted.end()) {
        throw DataError(fmt::format("{}:{}: column '{}' stands twice in the header", source,
                                    line_number, *twice));
      }
      table.columns_ = std::move(cells);
      continue;
    }
    if (cells.size() != table.columns_.size()) {
      throw DataError(fmt::format("{}:{}: {} cells, but the header has {} columns", source,
                                  line_number, cells.size(), table.columns_.size()));
    }
    table.rows_.push_back(std::move(cells));
    table.lines_.push_back(line_number);
  }
  if (table.columns_.empty()) throw DataError(source + ": no header line");
  return table;
}

CsvTable CsvTable::read(const std::string& path) { return parse(readFile(path), path); }

bool CsvTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", source_, lines_.at(row));
}

std::size_t CsvTable::indexOf(const std::string& column) const {
  const auto it = std::find(columns_.begin(), columns_.end(), column);
  if (it == columns_.end()) {
    throw DataError(fmt::format("{}: no column '{}'; there are {}", source_, column,
                                fmt::join(columns_, ", ")));
  }
  return static_cast<std::size_t>(it - columns_.begin());
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  return rows_.at(row)[indexOf(column)];
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  const std::string& cell = text(row, column);
  try {
    const double value = parseDouble(cell);
    if (std::isfinite(value)) return value;
  } catch (const std::invalid_argument&) {  // said below, with file and line
  }
  throw DataError(
      fmt::format("{}: column {} holds '{}', not a finite number", place(row), column, cell));
}

}  // namespace quad_support
