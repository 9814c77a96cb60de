#include "openr/signal_text.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>

namespace openr_host {
namespace {

std::string JsonOf(const SignalText& text) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  text.WriteAsJsonTo(ends[1]);
  close(ends[1]);
  char buffer[2048];
  const ssize_t size = read(ends[0], buffer, sizeof buffer);
  close(ends[0]);
  return {buffer, static_cast<size_t>(size)};
}

std::string ErrorOf(const SignalText& text) {
  return nlohmann::json::parse(JsonOf(text))["error"].get<std::string>();
}

TEST(SignalTextTest, AsJsonItSaysTheSameWithoutTheLastLineEnd) {
  SignalText text;
  text.Add("OBJECT \"a\\b\", message ").AddNumber(12).Add("\nSTACK\n");
  EXPECT_EQ(ErrorOf(text), "OBJECT \"a\\b\", message 12\nSTACK");
  EXPECT_EQ(JsonOf(text).back(), '\n');
}

TEST(SignalTextTest, WhatDoesNotFitIsLeftOutAndTheObjectIsClosedAllTheSame) {
  SignalText text;
  for (int i = 0; i < 2000; ++i) text.Add("\"");
  const std::string error = ErrorOf(text);
  EXPECT_GT(error.size(), 400u);
  EXPECT_EQ(error, std::string(error.size(), '"'));
}

}  // namespace
}  // namespace openr_host
