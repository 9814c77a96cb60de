// Runs Sony's OPEN-R SDK with its cross compiler, which makes images for the robot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

class RobotSdk {
 public:
  // Returns the SDK that OPENRSDK_ROOT names.  Throws std::runtime_error if the variable or a tool
  // is missing, or if the SDK is this project's own tree, which builds for the host.
  static RobotSdk FromEnvironment();

  // Uses the SDK in the folder `root`.  Throws std::runtime_error if the folder or a tool is
  // missing, or if the SDK is this project's own tree.
  explicit RobotSdk(const std::filesystem::path& root);

  // Sets whether RobotSdk prints every command before it runs the command.
  void set_verbose(bool is_verbose) { is_verbose_ = is_verbose; }

  const std::filesystem::path& root() const { return root_; }

  // Returns the folder of the SDK with the base of a Memory Stick, the system files to which
  // objects are added.  `model` is a folder such as "MS_ERS200"; `flavour` is BASIC, WLAN or
  // WCONSOLE; `is_protected` asks for memory protection.  If there is no such base, throws
  // std::runtime_error that lists the bases of this model.
  std::filesystem::path BaseStick(const std::string& model, const std::string& flavour,
                                  bool is_protected) const;

  // Writes def.h, entry.h and the stub to `folder`.  Throws std::runtime_error when stubgen2 fails;
  // stubgen2 itself prints the reason.  Compile() and Link() also throw when their tools fail.
  void GenerateStub(const std::filesystem::path& config, const std::filesystem::path& folder) const;

  // Compiles `source` to an object file.  `options` are flags such as -I and -D.
  void Compile(const std::filesystem::path& source, const std::filesystem::path& object,
               const std::vector<std::string>& options) const;

  // Links an image for the robot.  `libraries` are flags such as "-lInternet".  Throws if the image
  // is not for the robot's processor.
  void Link(const std::filesystem::path& ocf, const std::vector<std::filesystem::path>& objects,
            const std::vector<std::string>& libraries, const std::filesystem::path& image) const;

  // Returns the program that lists the symbols of object files: the SDK's nm, or else this
  // machine's nm, which can read these files, too.
  std::string SymbolLister() const;

 private:
  void Run(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
           const std::string& what) const;
  std::string Tool(const char* name) const;

  std::filesystem::path root_;
  bool is_verbose_ = false;
};

// Returns "" if the file is a 32-bit little-endian MIPS program, else a text that says what the
// file is.
std::string RobotImageProblem(const std::filesystem::path& image);

}  // namespace openr_host
