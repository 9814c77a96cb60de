#include "kit/new_stick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "cli/copy_file.h"
#include "kit/check_boot.h"
#include "kit/stick_draft.h"
#include "kit/stick_merge.h"
#include "kit/text_files.h"
#include "runtime/base/read_file.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"
#include "runtime/config/object_config.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kNoConnections[] = "# subject observer\n";

void Write(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const std::string problem = WriteText(file, text);
  if (!problem.empty()) throw std::runtime_error(problem);
}

// Returns the name that the image `file` gets on the stick: its own name in upper case.  Throws if
// a stick cannot have a file of this name.
std::string ImageName(const std::string& file) {
  std::string name = fs::path(file).filename();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string problem = ShortNameProblem(name);
  if (problem.empty() && !name.ends_with(".BIN")) problem = "an image is a file such as HELLO.BIN";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) problem = "there is no such file";
  if (!problem.empty()) throw std::runtime_error(fmt::format("{}: {}", file, problem));
  return name;
}

// Copies the images to the folder `objects`, and returns the text of an OBJECT.CFG that lists them.
std::string PutImages(const std::vector<std::string>& images, const fs::path& objects) {
  std::string list;
  std::set<std::string> names;
  for (const std::string& image : images) {
    const std::string name = ImageName(image);
    if (!names.insert(name).second)
      throw std::runtime_error(fmt::format("{}: another image has the name {}", image, name));
    CopyFile(image, WithCaseOnDisk(objects, name), fs::copy_options::overwrite_existing);
    list += fmt::format("/MS/OPEN-R/MW/OBJS/{}\n", name);
  }
  return list;
}

// Adds the lines `ours` to `file`, a configuration file of the stick.  Creates `file` if it was not
// copied from the user's base (NewStickOptions::base).
void MergeInto(const fs::path& file, const std::string& ours) {
  Write(file, MergeConfig(ReadText(file).value_or(""), ours));
}

// Copies the OPEN-R/ of the folder `base` to the stick `root`.  Throws if `base` has no base image.
void CopyBase(const std::string& base, const fs::path& root) {
  const fs::path tree = FindEntry(base, "OPEN-R");
  const std::string problem = tree.empty()          ? "there is no OPEN-R/ in it"
                              : !HasBaseImage(base) ? "it has no base image"
                                                    : "";
  if (!problem.empty())
    throw std::runtime_error(fmt::format("--base {}: {}; {}", base, problem, BaseImageContents()));
  CopyTree(tree, root / "OPEN-R");
}

// Returns the names of the images in OPEN-R/MW/OBJS of the stick `root` that no section of its
// OBJECT.CFG names, so that no robot loads them.
std::vector<std::string> UnlistedImages(const fs::path& root) {
  const std::string text = ReadText(WithCaseOnDisk(root, "OPEN-R/MW/CONF/OBJECT.CFG")).value_or("");
  const std::vector<ObjectRecord> records =
      ParseObjectConfig("OBJECT.CFG", text, kEveryDesign).objects;
  std::vector<std::string> unlisted;
  for (const auto& entry : fs::directory_iterator(WithCaseOnDisk(root, "OPEN-R/MW/OBJS"))) {
    const std::string name = entry.path().filename();
    const auto names_it = [&name](const ObjectRecord& record) {
      return EqualsIgnoringCase(record.path, "/MS/OPEN-R/MW/OBJS/" + name);
    };
    if (LowerCase(entry.path().extension()) == ".bin" &&
        std::none_of(records.begin(), records.end(), names_it))
      unlisted.push_back(name);
  }
  std::sort(unlisted.begin(), unlisted.end());
  return unlisted;
}

}  // namespace

std::vector<std::string> MakeNewStick(const NewStickOptions& options) {
  StickDraft draft(options.output);
  const fs::path root = draft.stick();
  if (!options.base.empty()) CopyBase(options.base, root);
  for (const char* folder : {"OPEN-R/MW/CONF", "OPEN-R/MW/OBJS", "OPEN-R/MW/DATA/P"})
    fs::create_directories(WithCaseOnDisk(root, folder));
  const std::string list = PutImages(options.images, WithCaseOnDisk(root, "OPEN-R/MW/OBJS"));
  MergeInto(WithCaseOnDisk(root, "OPEN-R/MW/CONF/OBJECT.CFG"), list);
  const std::string connections =
      options.connections.empty() ? kNoConnections : ReadFileOrThrow(options.connections);
  MergeInto(WithCaseOnDisk(root, "OPEN-R/MW/CONF/CONNECT.CFG"), connections);
  if (!options.wlan.empty()) PutWlanFile(root, options.wlan);
  std::vector<std::string> unlisted = UnlistedImages(root);
  draft.Finish();
  return unlisted;
}

std::string PutWlanFile(const std::string& stick, const std::string& text) {
  if (FindEntry(stick, "OPEN-R").empty())
    throw std::runtime_error(fmt::format("{}: is no stick, there is no OPEN-R/ in it", stick));
  const fs::path file = WithCaseOnDisk(stick, "OPEN-R/SYSTEM/CONF/WLANCONF.TXT");
  Write(file, text);
  return file;
}

}  // namespace openr_host
