// The fuzz target serve: requests to openr serve.
#include <nlohmann/json.hpp>

#include "cli/json_text.h"
#include "openr/serve/command_table.h"
#include "runtime/base/hasher.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::serve(std::string_view bytes) {
  auto request = TryParseJson<nlohmann::json>(bytes);
  if (request.is_discarded() || !CompleteRequest(&request).empty()) return false;
  const auto command = request["do"].get<std::string>();
  ReachFuzzState(HashBytes(command.data(), command.size()));
  return request.value("frames", nlohmann::json()) > 70;
}

}  // namespace openr_host
