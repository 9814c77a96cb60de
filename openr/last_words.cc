#include "openr/last_words.h"

#include <utility>

namespace openr_host {
namespace {

LastWords* g_newest = nullptr;

}  // namespace

LastWords::LastWords(std::function<void()> say)
    : say_(std::move(say)), outer_(std::exchange(g_newest, this)) {}

LastWords::~LastWords() { g_newest = outer_; }

void SayLastWords() {
  for (LastWords* each = std::exchange(g_newest, nullptr); each != nullptr; each = each->outer_)
    each->say_();
}

}  // namespace openr_host
