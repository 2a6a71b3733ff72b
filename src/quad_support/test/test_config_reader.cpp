#include <gtest/gtest.h>

#include "quad_support/config_reader.hpp"
#include "quad_support/errors.hpp"

using quad_support::ConfigError;
using quad_support::ConfigReader;
using quad_support::Range;

namespace {

ConfigReader parse(const std::string& text) { return ConfigReader::fromText(text, "c.yaml"); }

template <class F>
std::string messageOf(F&& f) {
  try {
    f();
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(ConfigReader, ReadsEveryKind) {
  const auto c = parse("a: 1.5\nn: 3\nb: true\nt: hello\nl: [1, 2.5]\nh: [3, 6]\ns:\n  x: 2\n");
  EXPECT_EQ(c.number("a", Range::positive()), 1.5);
  EXPECT_EQ(c.integer("n", 1, 5), 3);
  EXPECT_TRUE(c.boolean("b"));
  EXPECT_EQ(c.text("t"), "hello");
  EXPECT_EQ(c.numbers("l", Range::any(), 2)[1], 2.5);
  EXPECT_EQ(c.integers("h", 1, 9)[1], 6);
  EXPECT_EQ(c.section("s").number("x", Range::any()), 2.0);
  EXPECT_NO_THROW(c.finish());
}

TEST(ConfigReader, MessagesNameFileLineKeyValueAndLimit) {
  const auto c = parse("timing:\n  period: -0.1\n  list: [1, 200]\n  word: 1s\n  nan: .nan\n")
                     .section("timing");
  EXPECT_EQ(messageOf([&] { c.number("period", Range::positive("s")); }),
            "c.yaml:2: timing.period = -0.1; must be > 0 s");
  EXPECT_EQ(messageOf([&] { c.integers("list", 1, 184); }),
            "c.yaml:3: timing.list[1] = 200; must be a whole number in 1..184");
  EXPECT_EQ(messageOf([&] { c.number("word", Range::any("s")); }),
            "c.yaml:4: timing.word = 1s; must be a finite number in s");
  EXPECT_EQ(messageOf([&] { c.number("nan", Range::closed(0, 1)); }),
            "c.yaml:5: timing.nan = .nan; must be a finite number in [0, 1]");
  EXPECT_EQ(messageOf([&] { c.number("mass", Range::positive("kg")); }),
            "c.yaml:1: timing.mass is missing; it must be > 0 kg");
}

TEST(ConfigReader, UnknownAndDuplicateKeysAreErrors) {
  EXPECT_EQ(messageOf([] { parse("a: 1\nb: 2\na: 3\n"); }),
            "c.yaml:3: a stands twice (first on line 1); remove one");
  const auto c = parse("a: 1\nb: 2\n");
  c.number("a", Range::any());
  EXPECT_EQ(messageOf([&] { c.finish(); }),
            "c.yaml:2: b is not a key of this program; known here: a");
}

TEST(ConfigReader, AMisspeltKeyIsNamed) {
  const auto c = parse("design:\n  horizon: 1\n  gama_w: 20\n").section("design");
  EXPECT_EQ(messageOf([&] { c.number("gamma_w", Range::positive()); }),
            "c.yaml:1: design.gamma_w is missing; it must be > 0 (is design.gama_w, line 3, "
            "meant?)");
  EXPECT_EQ(messageOf([&] { c.number("closeness", Range::positive()); }),
            "c.yaml:1: design.closeness is missing; it must be > 0");
  const auto extra = parse("step: 1\nstepp: 2\n");
  extra.number("step", Range::any());
  EXPECT_EQ(messageOf([&] { extra.finish(); }),
            "c.yaml:2: stepp is not a key of this program, did you mean step?; known here: step");
}

TEST(ConfigReader, WhatIsNoFiniteNumberIsSaidToBeNone) {
  const auto c = parse("a: .inf\nb: abc\nc: [1, -.inf]\nd: '5'\n");
  EXPECT_EQ(messageOf([&] { c.number("a", Range::positive("kg")); }),
            "c.yaml:1: a = .inf; must be a finite number > 0 kg");
  EXPECT_EQ(messageOf([&] { c.number("b", Range::nonNegative("s")); }),
            "c.yaml:2: b = abc; must be a finite number >= 0 s");
  EXPECT_EQ(messageOf([&] { c.numbers("c", Range::open(0, 2, "m")); }),
            "c.yaml:3: c[1] = -.inf; must be a finite number in (0, 2) m");
  EXPECT_EQ(messageOf([&] { c.number("d", Range::any()); }),
            "c.yaml:4: d = \"5\"; must be a finite number");
}

TEST(ConfigReader, BrokenYamlNamesTheLine) {
  EXPECT_EQ(messageOf([] { parse("a: 1\n  b: 2\n"); }).substr(0, 9), "c.yaml:2:");
  EXPECT_EQ(messageOf([] { parse("just text\n"); }),
            "c.yaml:1: the file must be a map of keys and values");
}

TEST(ConfigReader, ASecondDocumentIsRefused) {
  EXPECT_EQ(messageOf([] { parse("a: 1\n---\n# more\nb: 2\n"); }),
            "c.yaml:4: a second YAML document begins here; remove the line '---' before it, or "
            "what follows");
  EXPECT_NE(messageOf([] { parse("---\n---\na: 1\n"); }).find("c.yaml:3: a second YAML document"),
            std::string::npos);
  EXPECT_EQ(parse("---\na: 1\n...\n---\n").number("a", Range::any()), 1.0);
  EXPECT_EQ(messageOf([] { parse(""); }), "c.yaml:1: the file must be a map of keys and values");
}

TEST(ConfigReader, ValuesStandOnOneLineInComplaints) {
  const auto c = parse("list:\n  - 1\n  - {x: '2'}\nmap:\n  y:\n    - 3\ntext: |\n  4\n  5\n");
  EXPECT_EQ(messageOf([&] { c.number("list", Range::any()); }),
            "c.yaml:2: list = [1, {x: \"2\"}]; must be a finite number");
  EXPECT_EQ(messageOf([&] { c.number("map", Range::positive("kg")); }),
            "c.yaml:5: map = {y: [3]}; must be a finite number > 0 kg");
  EXPECT_EQ(messageOf([&] { c.number("text", Range::any()); }),
            "c.yaml:7: text = \"4\\n5\\n\"; must be a finite number");
  EXPECT_EQ(c.value("list"), "[1, {x: \"2\"}]");
}

TEST(ConfigReader, ANumberInQuotesIsShownInQuotes) {
  const auto c = parse("a: \"20\"\nb: 'sin'\nc: ['1']\nd: ''\n");
  EXPECT_EQ(messageOf([&] { c.number("a", Range::any()); }),
            "c.yaml:1: a = \"20\"; must be a finite number");
  EXPECT_EQ(messageOf([&] { c.choice("b", {"cos"}); }), "c.yaml:2: b = sin; must be one of: cos");
  EXPECT_EQ(messageOf([&] { c.integers("c", 0, 9); }),
            "c.yaml:3: c[0] = \"1\"; must be a whole number in 0..9");
  EXPECT_EQ(messageOf([&] { c.text("d"); }), "c.yaml:4: d = \"\"; must not be empty");
}

TEST(ConfigReader, OverridesReplaceValuesAndKeepTheirLines) {
  const std::string text = "a:\n  b: 1\n  c: [1, 2, 3]\nd: {e: 4}\n";
  const auto in = ConfigReader::fromText(text, "f.yaml",
                                         {{"a.b", "7"}, {"a.c[1]", "-5"}, {"d", "{g: [1, x]}"}});
  const auto a = in.section("a");
  EXPECT_EQ(a.number("b", Range::any()), 7.0);
  EXPECT_EQ(a.numbers("c", Range::any()), (std::vector<double>{1, -5, 3}));
  EXPECT_EQ(in.section("d").value("g"), "[1, x]");
  EXPECT_EQ(in.section("d").values("g"), (std::vector<std::string>{"1", "x"}));
  EXPECT_EQ(in.keys(), (std::vector<std::string>{"a", "d"}));
  EXPECT_EQ(ConfigReader::fromText(text, "f.yaml", {{"a.new", "7"}})
                .section("a")
                .number("new", Range::any()),
            7.0);
  try {
    a.numbers("c", Range::positive("m"));
    FAIL();
  } catch (const quad_support::ConfigError& e) {
    EXPECT_STREQ(e.what(), "f.yaml:3: a.c[1] = -5; must be > 0 m");
  }
  const auto stray = ConfigReader::fromText(text, "f.yaml", {{"a.stray", "7"}}).section("a");
  EXPECT_EQ(messageOf([&] { stray.finish(); }),
            "f.yaml: a.stray is not a key of this program; known here: ");
  EXPECT_EQ(messageOf([&] {
              stray.number("stray", Range::positive("m")),
                  stray.number("stray", Range::closed(0, 1));
            }),
            "f.yaml: a.stray = 7; must lie in [0, 1]");
  for (const char* key : {"x.y", "a.x.y", "a.b.c", "a.c[3]", "a.c[-1]", "a.c.b", ""}) {
    EXPECT_THROW(ConfigReader::fromText(text, "f.yaml", {{key, "1"}}), quad_support::ConfigError)
        << key;
  }
}
