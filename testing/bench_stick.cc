#include "testing/bench_stick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "openr/simulation/run_stick.h"
#include "runtime/base/read_file.h"

namespace openr::testing {
namespace {

namespace fs = std::filesystem;
using openr_host::FolderStick;
using openr_host::TempFolder;

}  // namespace

BenchStick::BenchStick(const std::string& model)
    : folder_(std::make_unique<TempFolder>()),
      files_(std::make_unique<FolderStick>(folder_->path())) {
  for (const char* name : {"OPEN-R/MW/CONF", "OPEN-R/MW/OBJS", "OPEN-R/MW/DATA/P"}) {
    if (model.empty()) fs::create_directories(fs::path(folder_->path()) / name);
  }
  if (model.empty()) return;
  if (!fs::is_directory(fs::path(model) / "OPEN-R")) {
    throw std::runtime_error(fmt::format(
        "{}: holds no folder OPEN-R; a stick is a folder like the root of a Memory Stick", model));
  }
  openr_host::CopyStick(model, folder_->path());
}

void BenchStick::Write(const std::string& name, std::string_view bytes) {
  // Creates the missing folders above the file, the outermost first.  Looks each folder up with
  // Locate(), because it may exist under a name that differs only in upper and lower case.
  for (size_t end = name.find('/', 4); end != std::string::npos; end = name.find('/', end + 1)) {
    const Location folder = Locate(name.substr(0, end));
    if (folder.error == 0 && !folder.exists) fs::create_directory(folder.path);
  }
  const Location file = Locate(name);
  std::ofstream out(file.error == 0 ? file.path : "", std::ios::binary | std::ios::trunc);
  if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush()) {
    throw std::runtime_error(fmt::format(
        "'{}' cannot be written: names of the stick are like /MS/OPEN-R/MW/DATA/P/TABLE.TXT",
        name));
  }
}

std::vector<std::string> BenchStick::List(const std::string& folder) {
  std::vector<std::string> names;
  const Location place = Locate(folder);
  if (!place.exists) return names;
  for (const auto& entry : fs::recursive_directory_iterator(place.path)) {
    if (entry.is_directory()) continue;
    names.push_back("/MS/" + entry.path().lexically_relative(folder_->path()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void BenchStick::Remove(const std::string& name) {
  const Location file = Locate(name);
  if (file.exists) fs::remove_all(file.path);
}

void BenchStick::ImportImage(const std::string& host_file, const std::string& name) {
  const std::optional<std::string> bytes = openr_host::ReadFile(host_file);
  if (!bytes) {
    throw std::runtime_error(fmt::format(
        "{}: cannot be read; the image of an object is what openr_add_object() builds ({})",
        host_file, std::strerror(errno)));
  }
  Write(name, *bytes);
  const fs::path debug = fs::path(host_file).replace_extension(".DBG");
  const fs::path link = fs::path(Locate(name).path).replace_extension(".DBG");
  // Removes the link of an image that was imported before under the same name, because this link
  // leads to the debug information of that image.
  fs::remove(link);
  if (fs::exists(debug)) fs::create_symlink(fs::canonical(debug), link);
}

void BenchStick::MoveToCopy() {
  auto folder = std::make_unique<TempFolder>();
  openr_host::CopyStick(folder_->path(), folder->path());
  files_ = std::make_unique<FolderStick>(folder->path());
  folder_ = std::move(folder);
}

}  // namespace openr::testing
