#include "openr/panel/static_files.h"

#include <filesystem>
#include <map>
#include <sstream>
#include <string_view>
#include <system_error>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool IsBelow(const fs::path& file, const fs::path& folder) {
  const std::string relative = file.lexically_relative(folder);
  return !relative.empty() && relative[0] != '.';
}

}  // namespace

std::string FindStaticFile(const std::string& folder, const std::string& url_path) {
  if (folder.empty() || !url_path.starts_with('/')) return "";
  fs::path file = folder;
  std::istringstream parts(url_path.substr(1));
  for (std::string part; std::getline(parts, part, '/');) {
    if (part.empty() || part[0] == '.' || part.find('\0') != std::string::npos) return "";
    file /= part;
  }
  if (url_path.ends_with('/')) file /= "index.html";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return "";
  // Compares real paths, because a symbolic link in the folder may lead to a file outside of the
  // folder.
  const fs::path real = fs::canonical(file, error);
  const fs::path real_folder = error ? fs::path() : fs::canonical(folder, error);
  return !error && IsBelow(real, real_folder) ? real.string() : "";
}

std::string ContentTypeOf(const std::string& file) {
  static const std::map<std::string, std::string> types = {
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".webmanifest", "application/manifest+json"},
      {".txt", "text/plain; charset=utf-8"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".webp", "image/webp"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".wasm", "application/wasm"},
      {".glb", "model/gltf-binary"}};
  const auto found = types.find(fs::path(file).extension());
  return found == types.end() ? "application/octet-stream" : found->second;
}

std::string CacheControlOf(const std::string& url_path) {
  return url_path.starts_with("/assets/") ? "private, max-age=31536000, immutable" : "no-cache";
}

}  // namespace openr_host
