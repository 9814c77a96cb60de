// RunsLister, which answers the request "runs" of pages.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "openr/panel/outbox.h"

namespace openr_host {

// Asks all runs of this user for their state, in a thread of its own, because a run that is stopped
// does not answer.
class RunsLister {
 public:
  // `own` is the run ("default.123") that the server belongs to; "" if it belongs to none.
  explicit RunsLister(std::string own);
  RunsLister(const RunsLister&) = delete;
  RunsLister& operator=(const RunsLister&) = delete;

  // Puts the answer into the outbox, with `id`.
  void Ask(std::shared_ptr<Outbox> outbox, nlohmann::json id);

  // Returns whether a lister of this process has a thread.
  static bool HasThreads();

 private:
  struct Questions;
  const std::shared_ptr<Questions> questions_;
};

}  // namespace openr_host
