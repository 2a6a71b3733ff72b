/// Linear matrix inequalities as files in SDPA's sparse format, for other solvers.
#pragma once

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "lmi_solver.hpp"

namespace explore_opt::testing {

/// min -bᵀy s.t. Σ y_k A_k - (-C) ⪰ 0: the format's problem, with the same y.
inline void writeSdpa(const LmiProgram& program, const std::string& path) {
  std::ofstream out(path);
  out << program.reward.size() << "\n" << program.blocks.size() << "\n";
  for (const LmiBlock& block : program.blocks) out << block.size() << " ";
  out << "\n";
  for (const double reward : program.reward) out << fmt::format("{} ", -reward);
  out << "\n";
  for (std::size_t b = 0; b < program.blocks.size(); ++b) {
    const LmiBlock& block = program.blocks[b];
    const auto write = [&](Eigen::Index variable, const Eigen::MatrixXd& m) {
      for (Eigen::Index i = 0; i < m.rows(); ++i) {
        for (Eigen::Index j = i; j < m.cols(); ++j) {
          if (m(i, j) != 0.0)
            out << fmt::format("{} {} {} {} {}\n", variable, b + 1, i + 1, j + 1, m(i, j));
        }
      }
    };
    write(0, -block.constant);
    for (int k = 0; k < block.count; ++k) {
      Eigen::VectorXd unit = Eigen::VectorXd::Zero(program.reward.size());
      unit(block.first + k) = 1.0;
      write(block.first + k + 1, block.change(unit));
    }
  }
}

}  // namespace explore_opt::testing
