#include "openr/ending/signal_text.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/core/current.h"

namespace openr_host {
namespace {

std::string JsonOf(const SignalText& record, const SignalText& finding) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  WriteEndingAsJson(record, finding, "crash", Current{}, ends[1]);
  close(ends[1]);
  char buffer[8192];
  const ssize_t size = read(ends[0], buffer, sizeof buffer);
  close(ends[0]);
  return {buffer, static_cast<size_t>(size)};
}

std::string ErrorOf(const SignalText& text) {
  return nlohmann::json::parse(JsonOf(text, text))["error"].get<std::string>();
}

TEST(SignalTextTest, AsJsonItSaysTheSameWithoutTheLastLineEnd) {
  SignalText text;
  text.Add("OBJECT \"a\\b\", message ").AddNumber(12).Add("\nSTACK\n");
  EXPECT_EQ(ErrorOf(text), "OBJECT \"a\\b\", message 12\nSTACK");
  EXPECT_EQ(JsonOf(text, text).back(), '\n');
}

TEST(SignalTextTest, WhatDoesNotFitIsLeftOutAndTheObjectIsClosedAllTheSame) {
  SignalText text;
  for (int i = 0; i < 2000; ++i) text.Add("\"");
  const std::string error = ErrorOf(text);
  EXPECT_GT(error.size(), 400u);
  EXPECT_EQ(error, std::string(error.size(), '"'));
}

TEST(SignalTextTest, TheFindingIsThatOfAReport) {
  SignalText finding;
  finding.Add("crash");
  const nlohmann::json found = nlohmann::json::parse(JsonOf({}, finding))["findings"].at(0);
  EXPECT_EQ(found["severity"], "error");
  EXPECT_EQ(found["text"], "crash");
  EXPECT_EQ(found["time_s"], 0.0);
}

}  // namespace
}  // namespace openr_host
