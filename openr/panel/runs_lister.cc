#include "openr/panel/runs_lister.h"

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/json_text.h"
#include "openr/live/live_client.h"
#include "openr/live/live_folder.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kStatusTimeoutMs = 500;
constexpr size_t kQuestionsMax = 64;

std::atomic<int> g_lister_threads = 0;

// Returns the description of a run for pages.  If the run does not answer, the description has no
// model and no time.
Json DescribeRun(const LiveRun& run) {
  Json json = {{"name", run.name},
               {"process", run.process},
               {"run", std::filesystem::path(run.socket).filename().string()},
               {"model", nullptr},
               {"time_s", nullptr}};
  try {
    const Json status = LiveClient(run, kStatusTimeoutMs).Ask({{"do", "status"}});
    json["model"] = status.at("model");
    json["time_s"] = status.at("time_s");
  } catch (const std::exception&) {
    return json;
  }
  return json;
}

Json DescribeRuns(const std::string& own) {
  try {
    Json runs = Json::array();
    for (const LiveRun& run : LiveRuns()) runs.push_back(DescribeRun(run));
    return {{"runs", std::move(runs)}, {"own", own}};
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  }
}

}  // namespace

struct RunsLister::Questions {
  struct Question {
    std::shared_ptr<AnswerQueue> answers;
    nlohmann::json id;

    void Answer(Json answer) const {
      if (!id.is_null()) answer["id"] = id;
      answers->Add(JsonText(answer));
    }
  };

  explicit Questions(std::string the_own) : own(std::move(the_own)) {}
  const std::string own;
  std::mutex mutex;
  std::vector<Question> waiting;
  bool is_answering = false;  // true while a thread executes AnswerAll()

  void AnswerAll() {
    for (;;) {
      std::vector<Question> now;
      {
        // Takes the waiting requests and decides whether this thread ends, both under one lock.  So
        // no request of a page is lost: Ask() has added the request before, or starts a new thread.
        const std::lock_guard lock(mutex);
        now = std::exchange(waiting, {});
        is_answering = !now.empty();
      }
      if (now.empty()) return;
      const Json answer = DescribeRuns(own);
      for (const Question& question : now) question.Answer(answer);
    }
  }
};

RunsLister::RunsLister(std::string own) : questions_(std::make_shared<Questions>(std::move(own))) {}

void RunsLister::Ask(std::shared_ptr<AnswerQueue> answers, nlohmann::json id) {
  Questions::Question question = {std::move(answers), std::move(id)};
  const std::lock_guard lock(questions_->mutex);
  if (questions_->waiting.size() >= kQuestionsMax) {
    question.Answer({{"error", "too many requests wait for the list of runs"}});
    return;
  }
  questions_->waiting.push_back(std::move(question));
  if (std::exchange(questions_->is_answering, true)) return;
  ++g_lister_threads;
  try {
    std::thread([questions = questions_] {
      questions->AnswerAll();
      --g_lister_threads;
    }).detach();
  } catch (const std::system_error&) {
    // Drops the requests of pages for the state of the runs, because this computer cannot make a
    // thread now.  The next such request tries again to make a thread.
    --g_lister_threads;
    questions_->waiting.clear();
    questions_->is_answering = false;
    throw;
  }
}

bool RunsLister::HasThreads() { return g_lister_threads > 0; }

}  // namespace openr_host
