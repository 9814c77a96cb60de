// WaitState: the wait of a handler for a reply.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

class WaitState {
 public:
  // Records that the handler begins to wait at the virtual time `now_us` for a reply in `box`.
  void Begin(uint64_t box, int64_t now_us) {
    box_ = box;
    since_us_ = now_us;
  }
  // The results of the next two functions are valid only while a handler waits
  // (DeliveryState::blocked() is not null).
  uint64_t box() const { return box_; }
  int64_t since_us() const { return since_us_; }

  // Returns the text that tells users what the handler waits for: "the answer of IPStack (Send)".
  // Empty if the handler does not wait.
  const std::string& why() const { return why_; }
  void set_why(std::string_view why) { why_ = why; }

  // Returns whether the end of the wait depends on wall time and not on virtual time.
  // Requests::Call() to this object then ignores time-outs, which are in virtual time.
  bool is_untimed() const { return is_untimed_; }
  void set_untimed(bool is_untimed) { is_untimed_ = is_untimed; }

 private:
  uint64_t box_ = 0;
  int64_t since_us_ = 0;
  std::string why_;
  bool is_untimed_ = false;
};

}  // namespace openr_host
