#include <set>

#include "checks.hpp"
#include "explore_opt/identification.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using quad_support::CsvTable;

/// Rows of the table where `where` ("column=value") holds, all without it. They must follow one
/// another.
std::vector<std::size_t> selectRows(const CsvTable& table, const std::string& name,
                                    const std::string& where) {
  const auto equals = where.find('=');
  require(where.empty() || equals != std::string::npos, "--where {}; must be column=value", where);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool wanted =
        where.empty() || table.text(row, where.substr(0, equals)) == where.substr(equals + 1);
    if (!wanted) continue;
    require(rows.empty() || rows.back() + 1 == row,
            "{}: the rows with {} do not follow one another (gap after data row {})", name, where,
            rows.empty() ? 0 : rows.back() + 1);
    rows.push_back(row);
  }
  require(rows.size() >= 2, "{}: {} rows selected; at least 2 are needed", name, rows.size());
  return rows;
}

MatrixXd columns(const CsvTable& table, const std::vector<std::string>& names,
                 const std::vector<std::size_t>& rows, std::size_t count) {
  MatrixXd values(names.size(), count);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          table.number(rows[j], names[i]);
    }
  }
  return values;
}

}  // namespace

DataSet selectData(const CsvTable& table, const std::string& name,
                   const std::vector<std::string>& states, const std::vector<std::string>& inputs,
                   const std::string& where, double gamma_w) {
  std::set<std::string> taken;
  for (const auto* names : {&states, &inputs}) {
    for (const std::string& column : *names) {
      require(taken.insert(column).second,
              "--states and --inputs: column {} is given twice; a signal is one state or one input",
              column);
    }
  }
  const auto rows = selectRows(table, name, where);
  return {name, columns(table, states, rows, rows.size()),
          columns(table, inputs, rows, rows.size() - 1), gamma_w};
}

}  // namespace explore_opt
