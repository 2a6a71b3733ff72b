#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "quad_support/atomic_file.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/csv_table.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "quad_support/program.hpp"
#include "quad_support/random_stream.hpp"
#include "quad_support/sha256.hpp"

namespace fs = std::filesystem;
using namespace quad_support;

namespace {

class ScratchDirectory : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("quad_support_" + std::to_string(::getpid()));
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(dir_), fs::directory_iterator()));
  }
  fs::path dir_;
};

using AtomicFile = ScratchDirectory;

TEST(NumberFormat, RoundTripsEveryDouble) {
  const RandomStream random(7, 0, 0);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double value =
        random.normal(i) * std::pow(10.0, std::floor(600 * random.uniform(i, 1) - 300));
    EXPECT_EQ(parseDouble(shortest(value)), value);
  }
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(5e-324), "5e-324");
}

TEST(NumberFormat, RefusesWhatIsNotANumber) {
  for (const char* text : {"", "abc", "1.0x", "1,0", "0x10", "+-1"})
    EXPECT_THROW(parseDouble(text), std::invalid_argument);
  EXPECT_EQ(parseDouble(" +1.5 "), 1.5);
}

TEST(Sha256, MatchesThePublishedTestVector) {  // FIPS 180-4, example "abc"
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(RandomStream, NormalHasTheMomentsOfANormal) {
  const RandomStream random(1, 2, 3);
  const int n = 200000;
  double sum = 0, square = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal(static_cast<std::uint64_t>(i));
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  // Five standard errors: of the mean 1/sqrt(n), of the variance sqrt(2/n), of the fourth moment
  // sqrt(96/n).
  EXPECT_NEAR(sum / n, 0.0, 5 * std::sqrt(1.0 / n));
  EXPECT_NEAR(square / n, 1.0, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3.0, 5 * std::sqrt(96.0 / n));
}

TEST(RandomStream, EveryPartOfTheAddressMatters) {
  const double base = RandomStream(1, 2, 3).uniform(4, 5);
  EXPECT_EQ(base, RandomStream(1, 2, 3).uniform(4, 5));
  EXPECT_NE(base, RandomStream(9, 2, 3).uniform(4, 5));
  EXPECT_NE(base, RandomStream(1, 9, 3).uniform(4, 5));
  EXPECT_NE(base, RandomStream(1, 2, 9).uniform(4, 5));
  EXPECT_NE(base, RandomStream(1, 2, 3).uniform(9, 5));
  EXPECT_NE(base, RandomStream(1, 2, 3).uniform(4, 9));
}

TEST_F(AtomicFile, InPiecesIsThereWholeOrNotAtAll) {
  const std::string path = (dir_ / "big").string();
  {
    quad_support::AsideFile file(path);
    file.append("half");
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(std::filesystem::is_empty(dir_));
  quad_support::AsideFile file(path);
  file.append("first ");
  file.append("second");
  file.commit();
  EXPECT_EQ(quad_support::readFile(path), "first second");
}

TEST_F(AtomicFile, ReplacesTheWholeFile) {
  const std::string path = dir_ / "a.txt";
  writeFileAtomically(path, "first");
  writeFileAtomically(path, "second");
  EXPECT_EQ(readFile(path), "second");
  EXPECT_EQ(entries(), 1u);
  EXPECT_THROW(writeFileAtomically(dir_ / "none" / "a.txt", "x"), EnvironmentError);
}

TEST_F(AtomicFile, ComplaintsNameThePathThatWasAskedFor) {
  const std::string missing = dir_ / "none" / "a.txt";
  for (const auto& write : std::vector<std::function<void()>>{
           [&] { writeFileAtomically(missing, "x"); }, [&] { AsideFile file(missing); }}) {
    try {
      write();
      FAIL();
    } catch (const EnvironmentError& e) {
      EXPECT_EQ(e.what(), "cannot create " + missing + ": No such file or directory");
    }
  }
  EXPECT_THROW(writeFileAtomically(dir_, "x"), std::invalid_argument);
  EXPECT_EQ(entries(), 0u);
}

TEST(CommandLine, AWordThatIsNoCommandIsAnsweredWithThoseThereAre) {
  const auto answer = [](std::vector<const char*> words) {
    words.insert(words.begin(), "tool");
    return quad_support::argumentProblem("tool", "--out is required", {"design", "audit"},
                                         static_cast<int>(words.size()), words.data());
  };
  EXPECT_EQ(answer({"desing"}),
            "desing: no such command, did you mean design?; known: design, audit (tool --help "
            "tells more)");
  EXPECT_EQ(answer({"fly"}), "fly: no such command; known: design, audit (tool --help tells more)");
  for (const auto& words : std::vector<std::vector<const char*>>{{"design"}, {"--frob"}, {}})
    EXPECT_EQ(answer(words), "--out is required (tool --help tells more)");
}

// Where the user may write in the folder of a device, as root may in /dev, a rename would replace
// the device by a file.
TEST_F(AtomicFile, WritesIntoAPipeInsteadOfReplacingIt) {
  const std::string path = dir_ / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  writeFileAtomically(path, "whole");
  {
    AsideFile file(path);
    file.append(" in ");
    file.append("pieces");
    file.commit();
  }
  char received[64] = {};
  EXPECT_GT(::read(reader, received, sizeof received - 1), 0);
  ::close(reader);
  EXPECT_STREQ(received, "whole in pieces");
  EXPECT_TRUE(fs::is_fifo(path));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFile, ResultsAppearOnlyOnCommit) {
  const std::string path = dir_ / "results" / "run";
  {
    ResultDirectory results(path, false);
    results.write("targeted/trajectory.csv", "k\n");
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_TRUE(fs::is_empty(dir_ / "results"));
  ResultDirectory results(path, false);
  results.write("summary.json", "{}");
  results.commit();
  EXPECT_EQ(readFile(path + "/summary.json"), "{}");
  EXPECT_THROW(ResultDirectory(path, false), std::invalid_argument);
  ResultDirectory again(path, true);
  again.write("other.json", "[]");
  again.commit();
  EXPECT_FALSE(fs::exists(path + "/summary.json"));
  EXPECT_EQ(readFile(path + "/other.json"), "[]");
}

TEST_F(AtomicFile, ForceReplacesResultsOnly) {
  const std::string other = dir_ / "home";
  fs::create_directories(other + "/sub");
  writeFileAtomically(other + "/sub/letter.txt", "mine");
  EXPECT_THROW(ResultDirectory(other, true), std::invalid_argument);
  EXPECT_EQ(readFile(other + "/sub/letter.txt"), "mine");
  const std::string file = dir_ / "file.txt";
  writeFileAtomically(file, "mine too");
  EXPECT_THROW(ResultDirectory(file, true), std::invalid_argument);
  for (const char* name : {".", "..", "/", ""})
    EXPECT_THROW(ResultDirectory(name, true), std::invalid_argument) << name;
  EXPECT_EQ(entries(), 2u);
}

TEST(CsvTable, ReadsNumbersAndNamesMistakes) {
  const auto table = CsvTable::parse("t, phase,w0\n0,hold,1e3\n0.1,explore,nan\n", "x.csv");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(0, "w0"), 1000.0);
  EXPECT_EQ(table.text(1, "phase"), "explore");
  try {
    table.number(1, "w0");
    FAIL();
  } catch (const DataError& e) {
    EXPECT_STREQ(e.what(), "x.csv:3: column w0 holds 'nan', not a finite number");
  }
  EXPECT_THROW(table.text(0, "w9"), DataError);
  const auto from_a_spreadsheet =
      CsvTable::parse("\xEF\xBB\xBF\"t\",\"x y\"\r\n0,\"1\"\r\n", "y.csv");
  EXPECT_EQ(from_a_spreadsheet.columns(), (std::vector<std::string>{"t", "x y"}));
  EXPECT_EQ(from_a_spreadsheet.number(0, "x y"), 1.0);
  EXPECT_THROW(CsvTable::parse("a,a\n", "x"), DataError);
  EXPECT_THROW(CsvTable::parse("a,b\n1\n", "x"), DataError);
  EXPECT_THROW(CsvTable::parse("\n", "x"), DataError);
}

TEST(Program, ExceptionsBecomeExitCodes) {
  const auto code = [](auto error) { return runProgram("test", [&]() -> int { throw error; }); };
  EXPECT_EQ(code(ConfigError("x")), 2);
  EXPECT_EQ(code(std::invalid_argument("x")), 2);
  EXPECT_EQ(code(NegativeAnswer("x")), 3);
  EXPECT_EQ(code(SimulationError("x")), 4);
  EXPECT_EQ(code(EnvironmentError("x")), 5);
  EXPECT_EQ(code(Interrupted(2)), 130);
  EXPECT_EQ(runProgram("test", [] { return 3; }), 3);
}

}  // namespace
