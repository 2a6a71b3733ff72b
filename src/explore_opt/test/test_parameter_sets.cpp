/// Intervals of functions of the parameters, several data sets on one system, many states.
#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/identification.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::randomMatrix;
using quad_support::DataError;

namespace {

/// A stable random system under a disturbance of energy `energy`.
DataSet simulated(const Eigen::MatrixXd& Theta, std::uint64_t seed, double energy, double gamma_w,
                  int T = 80) {
  const auto nx = Theta.rows(), nu = Theta.cols() - nx;
  DataSet data{"set", Eigen::MatrixXd::Zero(nx, T + 1),
               randomMatrix(seed, 1, static_cast<int>(nu), T), gamma_w};
  Eigen::MatrixXd w = randomMatrix(seed, 2, static_cast<int>(nx), T);
  w *= std::sqrt(energy / w.squaredNorm());
  for (int k = 0; k < T; ++k) {
    data.X.col(k + 1) =
        Theta.leftCols(nx) * data.X.col(k) + Theta.rightCols(nu) * data.U.col(k) + w.col(k);
  }
  return data;
}

Eigen::MatrixXd system(std::uint64_t seed, int nx, int nu) {
  return 0.3 * randomMatrix(seed, 0, nx, nx + nu);
}

FeasibleSet setOf(const DataSet& data) {
  return feasibleSet(fitLeastSquares(data.X, data.U), data.gamma_w);
}

/// A point of the set, `radius` = 1 on its boundary, in a random direction.
Eigen::MatrixXd pointOf(const FeasibleSet& set, std::uint64_t seed, double radius) {
  Eigen::MatrixXd direction = randomMatrix(seed, 7, static_cast<int>(set.center.rows()),
                                           static_cast<int>(set.center.cols()));
  direction *= radius * std::sqrt(set.G) / direction.norm();
  return set.center + set.root.triangularView<Eigen::Upper>()
                          .solve(direction.transpose())
                          .transpose();  // ‖Δ Rᵀ‖² = radius² G
}

double valueOf(const ParameterFunction& f, const Eigen::MatrixXd& Theta) {
  return f.numerator.at(Theta) / (f.denominator ? f.denominator->at(Theta) : 1.0);
}

std::string parseError(const std::string& text) {
  try {
    parseFunction(text, 2, 1);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(ParameterFunction, IsReadAsWritten) {
  const Eigen::MatrixXd Theta = (Eigen::MatrixXd(2, 3) << 1, 2, 3, 4, 5, 6).finished();
  const auto value = [&](const char* text) { return valueOf(parseFunction(text, 2, 1), Theta); };
  EXPECT_EQ(value("A12"), 2.0);
  EXPECT_EQ(value("B2"), 6.0);
  EXPECT_EQ(value("A(2, 1) / B(1,1)"), 4.0 / 3.0);
  EXPECT_EQ(value(" - A12 + 2*B1 - 0.5"), 3.5);
  EXPECT_EQ(value("(A11 - B2)/(1e-1*A22 + 1)"), -5.0 / 1.5);
  EXPECT_EQ(value("m = 0.1/B2"), 0.1 / 6.0);
  EXPECT_EQ(value("1 + B1/A12"), 1.0 + 3.0 / 2.0);
  EXPECT_EQ(value("B1/A12 + 1"), 3.0 / 2.0 + 1.0);
  EXPECT_EQ(value("B1/A12 - A11/A12"), 1.0);
  EXPECT_EQ(value("3/B1 - 2"), -1.0);
  EXPECT_EQ(value("6/2*A12 - (1 - (A11 + 1))/4"), 6.25);
  EXPECT_EQ(value("2*(A12 - B1)/A22/2"), -0.2);
  EXPECT_EQ(parseFunction("m = 0.1/B2", 2, 1).name, "m");
  EXPECT_EQ(parseFunction("A12/B2", 2, 1).name, "A12/B2");
  EXPECT_EQ(parseFunction("B12", 2, 2).numerator.weights(0, 3), 1.0);
}

TEST(ParameterFunction, SaysWhatCannotBeRead) {
  EXPECT_EQ(parseError("A13"),
            "function 'A13' has an index out of range: A is 2 x 2 (at character 4); write sums of "
            "A12, B1, A(1,2) and numbers with + - *, or one such sum over another: "
            "'(A11 - 1)/B1'");
  EXPECT_NE(parseError("A12*B1").find("product of entries"), std::string::npos);
  EXPECT_NE(parseError("A11 + B1/A12").find("product of entries"), std::string::npos);
  EXPECT_NE(parseError("A11/0").find("divides by zero"), std::string::npos);
  EXPECT_NE(parseError(std::string(100000, '(')).find("too many parentheses"), std::string::npos);
  for (const char* text : {"",       "A",     "A1",   "C11",  "A12/",  "A12/B1/B2",        "A12*B1",
                           "*3",     "1e400", "..",   "A(1",  "A(1,2", "A(1;2)",           "A112",
                           "A12 B1", "A12 +", "(A12", "m =",  "0*",    "A(99999999999,1)", "B3",
                           "A01",    "=",     "2e",   "--A12"}) {
    EXPECT_NE(parseError(text), "") << text;
  }
}

TEST(Intervals, HoldEveryPointOfTheSetAndNoMore) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const FeasibleSet set = setOf(simulated(system(seed, 2, 1), seed, 0.5, 1.0));
    for (const char* text :
         {"A12", "A11 - 2*B2 + 1", "A12/(B2 + 3)", "(A21 + A22)/(4 - B1)", "1/(B2 + 5)"}) {
      const ParameterFunction f = parseFunction(text, 2, 1);
      const Interval interval = *intervalOf(set, f);
      EXPECT_DOUBLE_EQ(interval.value, valueOf(f, set.center));
      double least = INFINITY, largest = -INFINITY;
      for (std::uint64_t i = 0; i < 3000; ++i) {
        const double value = valueOf(f, pointOf(set, 1000 * seed + i, 1.0));
        least = std::min(least, value);
        largest = std::max(largest, value);
      }
      const double width = interval.upper - interval.lower;
      EXPECT_GE(least, interval.lower - 1e-12);
      EXPECT_LE(largest, interval.upper + 1e-12);
      // The best of 3000 directions in six dimensions lies within about a fifth of the end.
      EXPECT_LT(least, interval.lower + 0.2 * width) << text;
      EXPECT_GT(largest, interval.upper - 0.2 * width) << text;
    }
  }
}

TEST(Intervals, EndsOfAQuotientAreAttained) {
  // One state, one input: the boundary of the set is a curve, which can be walked.
  const FeasibleSet set =
      setOf(simulated((Eigen::MatrixXd(1, 2) << 0.7, 0.4).finished(), 3, 0.5, 1.0));
  const ParameterFunction f = parseFunction("A11/B1", 1, 1);
  double least = INFINITY, largest = -INFINITY;
  for (int i = 0; i < 100000; ++i) {
    const double angle = 2.0 * M_PI * i / 100000;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::MatrixXd point =
        set.center +
        (std::sqrt(set.G) * set.root.triangularView<Eigen::Upper>().solve(direction)).transpose();
    least = std::min(least, valueOf(f, point));
    largest = std::max(largest, valueOf(f, point));
  }
  const Interval interval = *intervalOf(set, f);
  // Near an extremum the walk misses it by the square of its step, 4e-9.
  EXPECT_NEAR(interval.lower, least, 1e-7);
  EXPECT_NEAR(interval.upper, largest, 1e-7);
}

TEST(Intervals, AreInfiniteWhereTheDenominatorCanVanish) {
  const FeasibleSet set =
      setOf(simulated((Eigen::MatrixXd(1, 2) << 0.7, 0.001).finished(), 3, 0.5, 5.0));
  const Interval interval = *intervalOf(set, parseFunction("A11/B1", 1, 1));
  EXPECT_EQ(interval.lower, -INFINITY);
  EXPECT_EQ(interval.upper, INFINITY);
  FeasibleSet empty = set;
  empty.G = -1.0;
  EXPECT_FALSE(intervalOf(empty, parseFunction("A11", 1, 1)).has_value());
}

TEST(Fusion, HoldsWhatLiesInEverySetAndIsNoWorseThanTheBest) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::MatrixXd Theta = system(seed, 2, 1);
    std::vector<FeasibleSet> sets;
    for (std::uint64_t j = 0; j < 3; ++j)
      sets.push_back(setOf(simulated(Theta, 10 * seed + j, 0.4, 0.5 + 0.3 * j, 40)));
    const FusedSet fused = fuse(sets, Eigen::MatrixXd::Identity(1, 1));
    EXPECT_FALSE(fused.set.falsified());
    EXPECT_TRUE(contains(fused.set, Theta));  // every γ_w is valid
    EXPECT_NEAR(fused.weights[0] + fused.weights[1] + fused.weights[2], 1.0, 1e-12);
    for (const FeasibleSet& set : sets)
      EXPECT_GE(*fused.set.lambdaBound(), *set.lambdaBound() * (1 - 1e-9));
    int inside = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Eigen::MatrixXd point = pointOf(sets[i % 3], i, 0.5);
      const bool in_all =
          contains(sets[0], point) && contains(sets[1], point) && contains(sets[2], point);
      if (!in_all) continue;
      ++inside;
      EXPECT_TRUE(contains(fused.set, point));
    }
    EXPECT_GT(inside, 10);
  }
}

TEST(Fusion, FollowsTheFormulaForAnyWeights) {
  const Eigen::MatrixXd Theta = system(5, 2, 1);
  const std::vector<FeasibleSet> sets = {setOf(simulated(Theta, 1, 0.4, 0.5)),
                                         setOf(simulated(Theta, 2, 0.4, 0.9))};
  for (const double part : {0.0, 0.3, 1.0}) {
    const std::vector<double> weights = {part, 1.0 - part};
    const FeasibleSet fused = fusedWith(sets, weights);
    // Σ λ_j (distance_j - G_j) is one and the same quadratic form for every point.
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Eigen::MatrixXd point = pointOf(sets[0], i, 2.0);
      const double sum = part * (distance(sets[0], point) - sets[0].G) +
                         (1.0 - part) * (distance(sets[1], point) - sets[1].G);
      EXPECT_NEAR(distance(fused, point) - fused.G, sum, 1e-11);  // numbers of the size of one
    }
  }
}

/// Two data sets, each of which moves one of two inputs. γ_w = 0.5 each, of which 0.4 is used.
std::vector<DataSet> oneInputEach(const Eigen::MatrixXd& Theta, std::uint64_t seed) {
  std::vector<DataSet> data;
  for (std::uint64_t j = 0; j < 2; ++j) {
    DataSet one = simulated(Theta, 10 * seed + j, 0.0, 0.5, 40);
    one.U.row(static_cast<Eigen::Index>(j)).setZero();
    Eigen::MatrixXd w = randomMatrix(seed, 20 + j, 2, 40);
    w *= std::sqrt(0.4 / w.squaredNorm());
    for (int k = 0; k < 40; ++k) {
      one.X.col(k + 1) =
          Theta.leftCols(2) * one.X.col(k) + Theta.rightCols(2) * one.U.col(k) + w.col(k);
    }
    data.push_back(one);
  }
  return data;
}

/// Cylinders whose intersection is bounded.
TEST(Fusion, OfSetsThatOnlyTogetherDetermineAll) {
  int outside_one = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::MatrixXd Theta = system(seed, 2, 2);
    const std::vector<DataSet> data = oneInputEach(Theta, seed);
    EXPECT_FALSE(identify({data[0]}, {}).exciting);
    EXPECT_FALSE(identify({data[0], data[0]}, {}).exciting);
    IdentificationRequest request;
    request.candidate = Theta;
    const Identification both = identify(data, request);
    ASSERT_TRUE(both.exciting);
    EXPECT_FALSE(both.falsified());
    EXPECT_TRUE(both.candidateIsMember());  // every γ_w is valid
    EXPECT_TRUE(both.candidateIsMember(0) && both.candidateIsMember(1));
    // The fused set is larger than what both leave possible: whoever is outside one is no member.
    for (std::uint64_t i = 0; i < 40; ++i) {
      request.candidate = pointOf(both.set, i, 1.0);
      const Identification asked = identify(data, request);
      const bool each = asked.candidateIsMember(0) && asked.candidateIsMember(1);
      EXPECT_EQ(asked.candidateIsMember(), each);
      if (!each) {
        ++outside_one;
        EXPECT_NE(complaint(asked).find("leaves possible"), std::string::npos);
      }
    }
    // Whatever weights were found, the set is Σ λ_j (residuals of set j) <= Σ λ_j γ_w,j.
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Eigen::MatrixXd point = pointOf(both.set, i, 1.5);
      double sum = 0.0;
      for (std::size_t j = 0; j < 2; ++j) {
        const DataSet& d = data[j];
        const Eigen::MatrixXd rest =
            d.X.rightCols(40) - point.leftCols(2) * d.X.leftCols(40) - point.rightCols(2) * d.U;
        sum += both.weights[j] * (rest.squaredNorm() - d.gamma_w);
      }
      EXPECT_NEAR(distance(both.set, point) - both.set.G, sum,
                  1e-10);  // numbers of the size of one
    }
  }
  EXPECT_GT(outside_one, 0);
}

TEST(Fusion, OfSetsThatOnlyTogetherDetermineTheUnknownEntries) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::MatrixXd Theta = system(seed, 2, 2);
    std::vector<DataSet> data = oneInputEach(Theta, seed);
    if (seed % 2 == 1) {  // fewer equations than unknowns
      data[0].X = Eigen::MatrixXd(data[0].X.leftCols(3));
      data[0].U = Eigen::MatrixXd(data[0].U.leftCols(2));
    }
    IdentificationRequest request;
    request.known = Eigen::MatrixXd::Constant(2, 4, NAN);
    request.known(0, 0) = Theta(0, 0);
    request.known(1, 1) = Theta(1, 1);
    EXPECT_FALSE(identify({data[1]}, request).exciting);
    EXPECT_FALSE(identify({data[1], data[1]}, request).exciting);
    request.candidate = Theta;
    const Identification both = identify(data, request);
    ASSERT_TRUE(both.exciting) << complaint(both);
    EXPECT_EQ(complaint(both), "");
    EXPECT_TRUE(both.candidateIsMember());  // every γ_w is valid
    EXPECT_TRUE((both.lower.array() <= Theta.array()).all());
    EXPECT_TRUE((both.upper.array() >= Theta.array()).all());
    // Whatever weights were found, the set is Σ λ_j (residuals of set j) <= Σ λ_j γ_w,j.
    for (std::uint64_t i = 0; i < 20; ++i) {
      Eigen::MatrixXd point = Theta + 0.1 * randomMatrix(seed, 30 + i, 2, 4);
      point(0, 0) = Theta(0, 0);
      point(1, 1) = Theta(1, 1);
      request.candidate = point;
      const Identification asked = identify(data, request);
      double sum = 0.0;
      for (std::size_t j = 0; j < 2; ++j) {
        const DataSet& d = data[j];
        const double residual =
            (d.X.rightCols(d.U.cols()) - point.leftCols(2) * d.X.leftCols(d.U.cols()) -
             point.rightCols(2) * d.U)
                .squaredNorm();
        sum += both.weights[j] * (residual - d.gamma_w);
        EXPECT_NEAR(asked.candidate_distances[j] - asked.data_sets[j].set.G, residual - d.gamma_w,
                    1e-10);  // numbers of the size of one
      }
      EXPECT_NEAR(*asked.candidate_distance - asked.set.G, sum, 1e-10);
    }
  }
}

TEST(Fusion, SeesWhatNoSetAloneSees) {
  // Two experiments on different systems: each fits its own γ_w, together they fit nothing.
  const std::vector<FeasibleSet> sets = {setOf(simulated(system(1, 2, 1), 1, 0.1, 0.2)),
                                         setOf(simulated(system(2, 2, 1), 2, 0.1, 0.2))};
  EXPECT_FALSE(sets[0].falsified() || sets[1].falsified());
  EXPECT_TRUE(fuse(sets, Eigen::MatrixXd::Identity(1, 1)).set.falsified());
  EXPECT_THROW(fuse({}, Eigen::MatrixXd::Identity(1, 1)), DataError);
}

TEST(Identification, OfSeveralDataSetsWithKnownEntries) {
  Eigen::MatrixXd Theta(2, 3), known = Eigen::MatrixXd::Constant(2, 3, NAN);
  Theta << 1, 0.1, 0.02, 0, 0.9, 0.5;
  known(0, 0) = 1.0;
  known(1, 0) = 0.0;
  const std::vector<DataSet> data = {simulated(Theta, 1, 0.01, 0.02),
                                     simulated(Theta, 2, 0.01, 0.02)};
  IdentificationRequest request;
  request.known = known;
  request.closeness = Eigen::MatrixXd::Constant(1, 1, 1.0);
  request.functions = {"m = 0.1/B2", "A11"};
  request.candidate = Theta;
  const Identification result = identify(data, request);
  ASSERT_TRUE(result.exciting);
  EXPECT_EQ(complaint(result), "");
  EXPECT_EQ(result.free.size(), 4u);
  EXPECT_EQ(result.Theta(0, 0), 1.0);
  EXPECT_EQ(result.lower(0, 0), 1.0);
  EXPECT_EQ(result.upper(0, 0), 1.0);
  EXPECT_TRUE(result.candidateIsMember());
  EXPECT_LT(result.functions[0]->lower, 0.2);
  EXPECT_GT(result.functions[0]->upper, 0.2);
  EXPECT_EQ(result.functions[1]->upper, 1.0);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_LE(result.lower(i, j), Theta(i, j));
      EXPECT_GE(result.upper(i, j), Theta(i, j));
    }
  }
  EXPECT_NEAR((result.Theta - Theta).norm(), 0.0, 0.05);
  request.candidate = Theta + Eigen::MatrixXd::Constant(2, 3, 0.5);
  EXPECT_THROW(identify(data, request), DataError);  // it denies what is known
  (*request.candidate)(0, 0) = 1.0;
  (*request.candidate)(1, 0) = 0.0;
  EXPECT_NE(complaint(identify(data, request)).find("not among the parameters"), std::string::npos);
}

TEST(Identification, NamesTheDataSetThatDoesNotExcite) {
  const Eigen::MatrixXd Theta = system(1, 2, 1);
  DataSet still = simulated(Theta, 1, 0.01, 0.02);
  still.name = "still.csv";
  still.U.setZero();
  const Identification alone = identify({still}, {});
  EXPECT_FALSE(alone.exciting);
  EXPECT_EQ(complaint(alone).rfind("still.csv: the data do not determine", 0), 0u);
  const Identification twice = identify({still, still}, {});
  EXPECT_FALSE(twice.exciting);
  EXPECT_NE(complaint(twice).find("not even together"), std::string::npos);
  IdentificationRequest structured;
  structured.known = Eigen::MatrixXd::Constant(2, 3, NAN);
  structured.known(0, 0) = Theta(0, 0);
  EXPECT_EQ(complaint(identify({still}, structured)).rfind("still.csv: the data do not", 0), 0u);
  EXPECT_NE(complaint(identify({still, still}, structured)).find("not even together"),
            std::string::npos);
  EXPECT_TRUE(identify({simulated(Theta, 1, 0.01, 0.02), still}, structured).exciting);
  DataSet other = simulated(system(1, 3, 1), 1, 0.01, 0.02);
  EXPECT_THROW(identify({still, other}, {}), DataError);
  EXPECT_THROW(identify({}, {}), DataError);
}

TEST(Identification, ManyStatesAndLongDataWithKnownStructure) {
  // A chain of 60 masses' worth of states, each coupled to its neighbours only: 238 of 3720
  // entries.
  const int nx = 60, nu = 2, T = 4000;
  Eigen::MatrixXd Theta = Eigen::MatrixXd::Zero(nx, nx + nu), known = Theta;
  for (int i = 0; i < nx; ++i) {
    for (int j = std::max(0, i - 1); j <= std::min(nx - 1, i + 1); ++j) {
      Theta(i, j) = i == j ? 0.6 : 0.15 + 0.001 * i;
      known(i, j) = NAN;
    }
  }
  for (const int i : {0, nx / 2}) {
    for (int j = 0; j < nu; ++j) {
      Theta(i, nx + j) = 1.0 + i + j;
      known(i, nx + j) = NAN;
    }
  }
  const DataSet data = simulated(Theta, 4, 1e-6, 1e-5, T);
  IdentificationRequest request;
  request.known = known;
  const Identification result = identify({data}, request);
  ASSERT_TRUE(result.exciting) << complaint(result);
  EXPECT_EQ(result.free.size(), 182u);
  EXPECT_FALSE(result.falsified());
  EXPECT_LT((result.Theta - Theta).norm(),
            std::sqrt(1e-6 / result.set.lambda_min_S));  // Cauchy-Schwarz
  request.candidate = Theta;
  EXPECT_TRUE(identify({data}, request).candidateIsMember());
}
