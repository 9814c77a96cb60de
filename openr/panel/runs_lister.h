// RunsLister, which answers the request "runs" of pages.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/panel/answer_queue.h"

namespace openr_host {

// Asks all runs of this user for their state.  Asks in a thread of its own, because a run whose
// process is stopped (SIGSTOP) does not answer and the server must not wait for it.
class RunsLister {
 public:
  // Makes a lister.  `own` is the run, such as "default.123", that has started this server; "" if a
  // user started it.
  explicit RunsLister(std::string own);
  RunsLister(const RunsLister&) = delete;
  RunsLister& operator=(const RunsLister&) = delete;

  // Collects the states of all runs, and puts them into `answers` as the answer to the request with
  // the id `id`.  Throws std::runtime_error if this computer cannot make a thread.
  void Ask(std::shared_ptr<AnswerQueue> answers, nlohmann::json id);

  // Returns whether the thread of any RunsLister of this process still runs.
  static bool HasThreads();

 private:
  struct Questions;
  const std::shared_ptr<Questions> questions_;
};

}  // namespace openr_host
