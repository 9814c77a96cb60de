#include "openr/explore/shorten.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

class Shortener {
 public:
  Shortener(const StillBreaks& still_breaks, int runs_max, Json* script, Json* answer)
      : still_breaks_(still_breaks), left_(runs_max), script_(*script), answer_(*answer) {}

  // Removes deviations from the list script_ as long as the property stays broken.  First tries the
  // empty list.  Then leaves out halves of the list, quarters and so on, and at last single
  // deviations.  Ends when every remaining deviation is needed, or at the limit of runs.
  void LeaveOut() {
    if (Try(Json::array())) return;
    size_t part = (script_.size() + 1) / 2;
    while (part > 0 && left_ > 0) {
      const bool any = LeaveOutParts(part);
      if (part == 1 && !any) return;
      part = part == 1 ? 1 : (part + 1) / 2;
      part = std::min(part, script_.size());
    }
  }

  void MakeSmaller() {
    for (size_t i = 0; i < script_.size(); ++i) {
      if (!script_[i].contains("us")) continue;
      // Does not make the field "us" of a first frame or a fault smaller, because this field has
      // the number of the frame or of the fault, and not a time.
      if (script_[i]["kind"] == "frame" || script_[i]["kind"] == "fault") continue;
      while (left_ > 0 && std::abs(script_[i]["us"].get<int64_t>()) > 1) {
        Json smaller = script_;
        smaller[i]["us"] = script_[i]["us"].get<int64_t>() / 2;
        if (!Try(std::move(smaller))) break;
      }
    }
  }

  int left() const { return left_; }

 private:
  bool LeaveOutParts(size_t part) {
    bool any = false;
    for (size_t begin = 0; begin < script_.size() && left_ > 0;) {
      const size_t end = std::min(begin + part, script_.size());
      Json rest = Json::array();
      for (size_t i = 0; i < script_.size(); ++i) {
        if (i < begin || i >= end) rest.push_back(script_[i]);
      }
      if (Try(std::move(rest))) {
        any = true;  // `begin` stays: after the removal, the next part of the list is there
      } else {
        begin = end;
      }
    }
    return any;
  }

  bool Try(Json script) {
    if (left_ <= 0) return false;
    --left_;
    std::optional<Json> answer = still_breaks_(script);
    if (!answer) return false;
    script_ = std::move(script);
    answer_ = std::move(*answer);
    return true;
  }

  const StillBreaks& still_breaks_;
  int left_;
  Json& script_;
  Json& answer_;
};

}  // namespace

int Shorten(const StillBreaks& still_breaks, int runs_max, Json* script, Json* answer) {
  Shortener shortener(still_breaks, runs_max, script, answer);
  shortener.LeaveOut();
  shortener.MakeSmaller();
  return runs_max - shortener.left();
}

}  // namespace openr_host
