/// Broken problems, designs, dumps, tables and functions, through the same calls the program makes.
/// Every one must end in an answer or in a message, never in a crash, an endless loop or exhausted
/// memory:
///
///   fuzz_inputs [number, or $EXPLORE_OPT_FUZZ, or 4000] [first seed, or 1]
///
/// Input number i depends on i alone, so `fuzz_inputs 1 i` repeats it. Ends with 1 and the input if
/// one of them throws what the program does not translate, and by signal where one crashes.
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "explore_opt/audit.hpp"
#include "explore_opt/baseline_signals.hpp"
#include "explore_opt/design_dump.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/frequency_choice.hpp"
#include "explore_opt/identification.hpp"
#include "explore_opt/identification_json.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/random_stream.hpp"

using namespace explore_opt;
using nlohmann::json;

namespace {

constexpr unsigned kSecondsPerInput = 60;
constexpr rlim_t kMemory = rlim_t{2} << 30;  // [bytes]

std::uint64_t current = 0;  // for the signal handler
std::string current_text;

void onSignal(int signal) {
  const std::string text = fmt::format("fuzz_inputs: input {} ended by signal {}\n{:.4000}\n",
                                       current, signal, current_text);
  (void)!write(STDERR_FILENO, text.data(), text.size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Draws of one input.
class Dice {
 public:
  explicit Dice(std::uint64_t input) : random_(input, 0, 0x66757a7a) {}
  double uniform() { return random_.uniform(draw_++); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform() * double(n)); }
  bool chance(double p) { return uniform() < p; }
  template <class T>
  const T& of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

 private:
  quad_support::RandomStream random_;
  std::uint64_t draw_ = 0;
};

const std::vector<std::string> kTokens = {"NaN",
                                          "Infinity",
                                          "1e999",
                                          "-1e308",
                                          "null",
                                          "true",
                                          "[[",
                                          "]]",
                                          "{",
                                          "}",
                                          "\"",
                                          ",",
                                          ":",
                                          "-",
                                          "0",
                                          "1e-320",
                                          "\\u0000",
                                          "\xff",
                                          "\n",
                                          " ",
                                          "nan",
                                          "inf",
                                          "18446744073709551616",
                                          "9007199254740993",
                                          "-1",
                                          "0.5",
                                          "1000000000",
                                          "[]",
                                          "{}",
                                          "\"x\""};

const std::vector<json>& values() {
  static const std::vector<json> kValues = {nullptr,
                                            true,
                                            -1,
                                            0,
                                            1,
                                            2,
                                            3,
                                            7,
                                            0.5,
                                            0.25,
                                            -0.5,
                                            1e308,
                                            -1e308,
                                            5e-324,
                                            1e15,
                                            1e-15,
                                            1000000000,
                                            2147483648u,
                                            -9007199254740993,
                                            "text",
                                            "sin",
                                            "both",
                                            json::array(),
                                            json::object(),
                                            {{}},
                                            {{1}},
                                            {1, 2},
                                            {{1, 2}, {3, 4}},
                                            {{1, 2}, {3}},
                                            {{1, nullptr}},
                                            {{1e200}},
                                            {{0, 0}, {0, 0}},
                                            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                            {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return kValues;
}

/// Changes one node somewhere in the value.
void mutateNode(json& value, Dice& dice) {
  if (value.is_structured() && !value.empty() && dice.chance(0.85)) {
    auto item = value.begin();
    std::advance(item, static_cast<std::ptrdiff_t>(dice.below(value.size())));
    if (dice.chance(0.08)) {
      value.erase(item);
    } else if (value.is_array() && dice.chance(0.08)) {
      const json copy = *item;
      value.push_back(copy);
    } else {
      mutateNode(*item, dice);
    }
    return;
  }
  if (value.is_number() && dice.chance(0.6)) {
    const double x = value.get<double>();
    value =
        dice.of<double>({-x, 2 * x, x / 2, x * 1e8, x * 1e-8, x + 1, x - 1, x * 1e300, x + 1e-9});
    return;
  }
  value = dice.of(values());
}

std::string mutateText(std::string text, Dice& dice) {
  const std::size_t at = dice.below(text.size() + 1);
  const std::size_t length = dice.below(12);
  switch (dice.below(5)) {
    case 0:
      return text.substr(0, at);
    case 1:
      return text.erase(std::min(at, text.size()), length);
    case 2:
      return text.insert(at, dice.of(kTokens));
    case 3:
      return text.insert(at, text.substr(at, length));
    default:
      if (at < text.size()) text[at] = static_cast<char>(dice.below(256));
      return text;
  }
}

std::string mutated(const json& start, Dice& dice) {
  json value = start;
  for (std::size_t n = dice.below(4); n > 0; --n) mutateNode(value, dice);
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  for (std::size_t n = dice.chance(0.3) ? 1 + dice.below(3) : 0; n > 0; --n)
    text = mutateText(text, dice);
  if (dice.chance(0.002)) text = std::string(100000, '[');
  return text;
}

struct Corpus {
  std::vector<json> problems, designs, dumps;
  std::vector<std::string> tables = {
      "k,phase,x,v,u\n0,a,0,0,1\n1,a,0.5,0.2,-1\n2,a,0.1,-0.3,1\n3,a,0.4,0.1,1\n4,b,0.2,0.5,-1\n5,"
      "b,-0.2,0.1,\n",
      "x,u\n0,1\n0.5,1\n0.76,-1\n-0.13,-1\n-0.55,\n",
      "x,v,u\n1e200,0,1\n0,1e-200,2\n1,1,1\n5,2,1\n1,1,\n"};
  std::vector<std::string> functions = {"m = 0.1/B2", "A12", "(A11 - 2*B1)/(B2 + 1)",
                                        "A(1,2)/A(2,1)"};

  Corpus() {
    problems.push_back(
        json::parse(R"({"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 37,
      "harmonics": [3, 6, 8], "phase": "sin", "gamma_w": 20, "D_des": 100})"));
    problems.push_back(
        json::parse(R"({"A": [[0.5]], "B": [[1, 0.3]], "T": 12, "frequencies": [0.11, 0.3],
      "phase": "both", "gamma_w": 1, "D_des": [[2, 0.5, 0], [0.5, 3, 0], [0, 0, 4]]})"));
    problems.push_back(json::parse(R"({"A": [[1.1, 0], [0.2, 0.5]], "B": [[1], [0]], "T": 20,
      "harmonics": [1, 4], "phase": "cos", "gamma_w": 1, "D_des": 5, "K": [[-0.5, 0]], "x0": [0, 0]})"));
    problems.push_back(json::parse(R"({"A": [[1, 0.2], [0, 1]], "B": [[0.02], [0.2]], "T": 25,
      "harmonics": [1, 3, 5], "phase": "cos", "gamma_w": 1, "D_des": 5, "K": [[-0.5, -1]], "x0": [1, 0],
      "cost": "input", "known": [[1, null, null], [0, null, null]], "u_max": 30})"));
    problems.push_back(json::parse(R"({"A": [[0.5, 0.1], [0, 0.3]], "B": [[1], [0.4]], "T": 15,
      "harmonics": [1, 3, 5], "phase": "sin", "gamma_w": 1, "D_des": [[1, 0, 0], [0, 0, 0], [0, 0, 2]],
      "experiments": 2})"));
    for (const json& problem : problems) {
      const std::string text = problem.dump();
      const DesignOptions options;
      const ExplorationProblem read = problemFromJson(text, "corpus");
      const DesignResult result = designExploration(read, options);
      designs.push_back(json::parse(designToJson(read, result).dump()));
      dumps.push_back(json::parse(dumpDesign(text, options, result)));
    }
  }
};

/// So small that a design takes milliseconds; larger ones are only read and checked.
bool isQuick(const ExplorationProblem& problem) {
  return problem.lines.num_samples <= 300 && problem.numAmplitudes() <= 16 &&
         problem.numRegressors() <= 6 && problem.experiments <= 3;
}

enum class Kind { kProblem, kDesign, kDump, kTable, kFrequencies, kFunction, kCount };

std::string textOf(Kind kind, const Corpus& corpus, Dice& dice, std::size_t which) {
  switch (kind) {
    case Kind::kDesign:
      return mutated(corpus.designs[which], dice);
    case Kind::kDump:
      return mutated(corpus.dumps[which], dice);
    case Kind::kTable: {
      std::string text = dice.of(corpus.tables);
      for (std::size_t n = dice.below(5); n > 0; --n) text = mutateText(text, dice);
      return text;
    }
    case Kind::kFunction: {
      std::string text = dice.of(corpus.functions);
      for (std::size_t n = dice.below(4); n > 0; --n) text = mutateText(text, dice);
      return text;
    }
    default:
      return mutated(corpus.problems[which], dice);
  }
}

void identifyTable(const std::string& text, const Corpus& corpus, Dice& dice) {
  const auto table = quad_support::CsvTable::parse(text, "fuzz");
  const std::vector<std::string> states =
      dice.chance(0.5) ? std::vector<std::string>{"x"} : std::vector<std::string>{"x", "v"};
  const auto nx = static_cast<int>(states.size());
  IdentificationRequest request;
  const std::string where = dice.chance(0.2) ? "phase=a" : "";
  if (dice.chance(0.4)) request.functions = {dice.of(corpus.functions)};
  if (dice.chance(0.4)) request.closeness = closenessFromJson(mutated(json(2.0), dice), "fuzz D");
  if (dice.chance(0.3))
    request.known = knownFromJson(
        mutated(nx == 1 ? json{{0.5, nullptr}} : json{{1, nullptr, nullptr}, {0, nullptr, nullptr}},
                dice),
        "fuzz known");
  if (dice.chance(0.3))
    request.candidate = thetaFromJson(
        mutated(nx == 1 ? json{{0.5, 0.5}} : json{{1, 0, 0}, {0, 1, 1}}, dice), "fuzz candidate");
  const DataSet data = selectData(table, "fuzz", states, {"u"}, where,
                                  dice.of<double>({1.0, 1e-9, 1e300, 0.0, -1.0}));
  const std::vector<DataSet> sets(dice.chance(0.2) ? 2 : 1, data);
  const Identification result = identify(sets, request);
  identificationToJson(result).dump();
  complaint(result);
}

/// What the program does with such a text. @returns whether it was solved, not refused
void use(Kind kind, const std::string& text, const Corpus& corpus, Dice& dice, std::size_t which) {
  switch (kind) {
    case Kind::kProblem: {
      const ExplorationProblem problem = problemFromJson(text, "fuzz");
      DesignOptions options;
      options.random_starts = 1;
      if (dice.chance(0.2)) {
        options.method = DesignMethod::kMm;
        options.max_iterations = 5;
      }
      if (!isQuick(problem)) return validate(problem);
      prettyJson(designToJson(problem, designExploration(problem, options)));
      return;
    }
    case Kind::kDesign: {
      const ExplorationProblem problem = problemFromJson(corpus.problems[which].dump(), "corpus");
      if (dice.chance(0.3)) amplitudesFromJson(text, "fuzz", problem);
      prettyJson(auditToJson(audit(problem, claimsFromJson(text, "fuzz", problem))));
      return;
    }
    case Kind::kDump: {
      const json dump = json::parse(text, nullptr, false);
      if (dump.is_object() && dump.contains("problem")) {
        if (!isQuick(problemFromJson(dump["problem"].dump(), "fuzz"))) return;
        // Many starts are a legal wish, but a long one.
        const json options = dump.value("options", json::object());
        for (const char* key : {"random_starts"}) {
          const bool number =
              options.is_object() && options.contains(key) && options[key].is_number();
          if (number && options[key].get<double>() > 20.0) return;
        }
      }
      replayDesign(text, "fuzz");
      return;
    }
    case Kind::kTable:
      return identifyTable(text, corpus, dice);
    case Kind::kFrequencies: {
      const ExplorationProblem problem = problemFromJson(text, "fuzz");
      FrequencyOptions options;
      options.lines = static_cast<int>(dice.below(6));
      options.band_high = dice.of<double>({0.5, 0.2, 0.01, 0.6, -1.0});
      if (isQuick(problem)) chooseFrequencies(problem, options);
      return;
    }
    default:
      parseFunction(text, 1 + static_cast<int>(dice.below(3)), 1 + static_cast<int>(dice.below(2)));
  }
}

/// Mostly what is quick; solving is a hundred times as slow as reading.
Kind kindOf(Dice& dice) {
  const double u = dice.uniform();
  return u < 0.07   ? Kind::kProblem
         : u < 0.30 ? Kind::kDesign
         : u < 0.32 ? Kind::kDump
         : u < 0.85 ? Kind::kTable
         : u < 0.86 ? Kind::kFrequencies
                    : Kind::kFunction;
}

/// 'a' answered, 'r' refused with a reason, 'n' a negative answer; 0 if it failed.
char tryInput(std::uint64_t input, const Corpus& corpus) {
  Dice dice(input);
  const Kind kind = kindOf(dice);
  const std::size_t which = dice.below(corpus.problems.size());
  const std::string text = current_text = textOf(kind, corpus, dice, which);
  std::string what;
  try {
    use(kind, text, corpus, dice, which);
    return 'a';
  } catch (const std::invalid_argument& e) {
    if (e.what()[0] != '\0') return 'r';
    what = "a refusal without a reason";
  } catch (const quad_support::NegativeAnswer&) {
    return 'n';
  } catch (const std::exception& e) {
    what = e.what();
  }
  std::fprintf(stderr, "fuzz_inputs: input %llu (kind %d): %s\n%.2000s\n",
               static_cast<unsigned long long>(input), static_cast<int>(kind), what.c_str(),
               text.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const char* wanted = argc > 1 ? argv[1] : std::getenv("EXPLORE_OPT_FUZZ");
  const std::uint64_t count = wanted ? std::strtoull(wanted, nullptr, 10) : 4000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const Corpus corpus;
  const rlimit memory{kMemory, kMemory};
  setrlimit(RLIMIT_AS, &memory);  // absurd sizes must be refused, not tried
  for (const int signal : {SIGSEGV, SIGFPE, SIGABRT, SIGALRM, SIGBUS, SIGILL})
    std::signal(signal, onSignal);
  std::map<char, std::uint64_t> tally;
  for (current = first; current < first + count; ++current) {
    alarm(kSecondsPerInput);
    ++tally[tryInput(current, corpus)];
    if (tally[0] >= 10) break;
  }
  alarm(0);
  std::printf(
      "%llu inputs: %llu answered, %llu refused with a reason, %llu negative, %llu failed\n",
      static_cast<unsigned long long>(current - first), static_cast<unsigned long long>(tally['a']),
      static_cast<unsigned long long>(tally['r']), static_cast<unsigned long long>(tally['n']),
      static_cast<unsigned long long>(tally[0]));
  return tally[0] == 0 && current == first + count ? 0 : 1;
}
