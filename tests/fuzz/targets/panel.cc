// The fuzz target panel: requests and messages of pages.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/base64.h"
#include "openr/panel/access.h"
#include "openr/panel/endpoints.h"
#include "openr/panel/page_queue.h"
#include "openr/panel/static_files.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::panel(std::string_view bytes) {
  static const Access access("0123456789abcdef0123456789abcdef", "127.0.0.1", 8080);
  FuzzBytes input(bytes);
  WebRequest request;
  request.path = input.Text(input.U8());
  request.host = input.Text(input.U8());
  request.origin = input.Text(input.U8());
  const bool has_file = access.FileRefusal(request).empty();
  access.SocketRefusal(request);
  const std::string found = FindStaticFile("/usr/include", request.path);
  FuzzCheck(found.empty() || found.starts_with("/usr/include/"), "a file outside of the folder");
  ContentTypeOf(request.path);
  CacheControlOf(request.path);
  FromBase64(request.origin);
  try {
    ParseEndpoint(request.host);
  } catch (const std::runtime_error&) {
  }
  PageQueue queue;
  while (!input.empty()) queue.Add(std::string(input.Text(input.U8())));
  while (!queue.empty()) queue.Next();
  return has_file && request.path.size() > 40;
}

}  // namespace openr_host
