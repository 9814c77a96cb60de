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
  if (request.is_discarded()) return false;
  std::string given;  // names of the parameters that the request has, before the others are added
  if (request.is_object()) {
    for (const auto& [key, value] : request.items()) given += key + ' ';
  }
  if (!CompleteRequest(&request).empty()) return false;
  given += request["do"].get<std::string>();
  ReachFuzzState(HashBytes(given.data(), given.size()));
  return request.value("frames", nlohmann::json()) > 70;
}

}  // namespace openr_host
