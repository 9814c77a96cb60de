// The fuzz target gateway_wire: the bytes of TCPGateway, and OPEN-R calls in them.
#include <algorithm>
#include <set>

#include "runtime/gateway/gateway_stream.h"
#include "runtime/gateway/proxy_wire.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

// The planted bug wants calls of as many different functions in one stream.
constexpr size_t kFunctions = 3;

}  // namespace

bool fuzz::gateway_wire(std::string_view bytes) {
  std::set<uint32_t> called;  // selectors of the calls that were understood
  FuzzBytes input(bytes);
  GatewayStream words, sets;
  bool is_broken = false;
  while (!input.empty() && !is_broken) {
    const std::string_view arrived = input.Text(size_t{1} + input.U8());
    words.Feed(arrived);
    sets.Feed(arrived);
    uint32_t word;
    while (words.NextWord(&word) == GatewayStream::Result::kTaken) {
    }
    GatewaySet set;
    GatewayStream::Result result;
    while ((result = sets.NextSet(&set)) == GatewayStream::Result::kTaken) {
      for (const std::string& item : set) {
        ProxyFrame frame;
        if (!DecodeProxyFrame(item, &frame).empty()) continue;
        FuzzCheck(frame.bytes.size() <= kProxyBytesMax, "the size of a call");
        if (frame.command == ProxyCommand::kCall) called.insert(frame.selector);
      }
    }
    is_broken = result == GatewayStream::Result::kBroken;
    FuzzCheck(is_broken != sets.error().empty(), "a broken stream has a reason");
  }
  // Notes how many functions are called, because calls of all functions have the same branches.
  ReachFuzzState(std::min(called.size(), kFunctions));
  return called.size() >= kFunctions;
}

}  // namespace openr_host
