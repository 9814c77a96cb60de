// A second stack, for robot_step().
#pragma once

#include <ucontext.h>

#include <vector>

namespace openr_host {

class LoopStackOfTest {
 public:
  void Run(void (*body)(void*), void* argument) {
    body_ = body;
    argument_ = argument;
    stack_.resize(size_t{256} << 10);
    current_ = this;
    getcontext(&there_);
    there_.uc_stack.ss_sp = stack_.data();
    there_.uc_stack.ss_size = stack_.size();
    there_.uc_link = &here_;
    makecontext(
        &there_, [] { current_->body_(current_->argument_); }, 0);
    swapcontext(&here_, &there_);
  }
  bool Leave() {
    swapcontext(&there_, &here_);
    return true;
  }
  void Continue() { swapcontext(&here_, &there_); }

 private:
  static inline LoopStackOfTest* current_ = nullptr;
  ucontext_t here_{}, there_{};
  std::vector<char> stack_;
  void (*body_)(void*) = nullptr;
  void* argument_ = nullptr;
};

}  // namespace openr_host
