//
// The files of the Memory Stick that remote clients may list, read, replace and delete: motions,
// and the image of the controller.
//
// All functions use buffers of a fixed size, for any number and size of files.  Functions that can
// fail return a RcStatus and set `why` to the reason.
//

#ifndef StickStore_h_DEFINED
#define StickStore_h_DEFINED

#include <string>

#include "MtnName.h"
#include "RemoteFiles.h"

// A file name that CheckName() has checked, and the kind of the file, which decides its folder.
struct StickName {
    int kind;  // a value of RcFileKind
    char name[MTN_NAME_SIZE];
};

class StickStore {
public:
    StickStore();

    // Sets the path of the folder that has the stick's folder MS: "" on the robot.
    void SetRoot(const std::string& root) { root_ = root; }

    // Checks that a remote client may use a file of this kind and name.  The name of a motion has
    // at most 8 characters before its ending .MTN, and no path; the only image is CONTROLL.BIN.
    int CheckName(int kind, const std::string& given, StickName* name, std::string* why) const;

    // Returns the path of the file `name`.  `kind` is an RcFileKind and selects the folder: the
    // folder of motions or the folder of images.
    std::string Path(int kind, const std::string& name) const;
    std::string Path(const StickName& file) const { return Path(file.kind, file.name); }

    // Reads the names of all motions and sorts them, for Count() and Name().  Reads at most 682
    // names and leaves out all others, because the robot's file system lists no more than 682 files
    // of a folder.
    void ReadMotions();
    // Returns the number of motions that ReadMotions() has read.
    int Count() const { return count_; }
    // Returns the name of motion number `index` in the sorted list.
    const char* Name(int index) const { return names_[index]; }

    // Returns the size of a file in bytes, or -1 when there is no such file.
    static long SizeOf(const std::string& path);

    // Reads up to `count` bytes from `offset` on into `bytes`.  Sets `size` to the size of the file
    // and returns the number of bytes read, or -1 when the file cannot be read.
    static int ReadPart(const std::string& path, Uint32 offset, Uint8* bytes, int count,
                        Uint32* size);

    // Gives the file `from` the name `to`, and replaces a file of this name.  When this fails, both
    // files are there as before, and `errno` has the reason.  `to` has an extension.
    //
    // Where the file system refuses to replace a file, the old file has another name for a moment,
    // such as WALK.~TN for WALK.MTN.  When the power fails in this moment, PutBack() gives the file
    // its name back.
    static bool Replace(const std::string& from, const std::string& to);

    // Completes every Replace() that was interrupted: gives the old file its name back, or removes
    // it if the new file is in its place.  Returns the path of a file or folder for which this
    // failed, or "".  Forgets the names that ReadMotions() has read.
    std::string PutBack();

    // Copies the file `from` to `to`.  When this fails, there is no file `to`, and `errno` has the
    // reason.
    bool Copy(const std::string& from, const std::string& to);

private:
    static const int MAX_MOTIONS = 682;
    static const int NAME_SIZE = 13;  // "NAME1234.MTN" with its closing NUL

    bool ReadNames(const char* extension);
    void Insert(const char* name);

    std::string root_;
    int count_;
    char names_[MAX_MOTIONS][NAME_SIZE];
    Uint8 copied_[512];  // buffer of Copy(); a member, because the stack of an object is small
};

#endif  // StickStore_h_DEFINED
