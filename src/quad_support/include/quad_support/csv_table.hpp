/// Tables of numbers with a header line, as the programs exchange them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quad_support {

/// A table read from CSV. Cells are kept as text; numbers are read where they are asked for, so
/// that a text column (a phase, say) does no harm.
class CsvTable {
 public:
  /// @throws DataError naming `source` and the line: no header, duplicate column, wrong number of
  /// cells
  static CsvTable parse(std::string_view text, const std::string& source);
  /// @throws std::invalid_argument if the file cannot be read, DataError as parse()
  static CsvTable read(const std::string& path);

  std::size_t rows() const { return rows_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }
  bool has(const std::string& column) const;
  const std::string& source() const { return source_; }
  std::string place(std::size_t row) const;  ///< "file:line", for a message

  /// The cell as text. @throws DataError if there is no such column (lists those there are)
  const std::string& text(std::size_t row, const std::string& column) const;
  /// The cell as a finite number. @throws DataError naming file, line, column and the text found
  double number(std::size_t row, const std::string& column) const;

 private:
  std::size_t indexOf(const std::string& column) const;

  std::string source_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

}  // namespace quad_support
