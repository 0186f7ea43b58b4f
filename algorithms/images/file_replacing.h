// How a complete file takes the place of its earlier version: for AtomicFile, and for files that are written under
// another name for longer.
#pragma once

#include <string>

namespace relief {

// Throws WorkError for an errno. target: the path that is written, which may be that of a symbolic link's target.
[[noreturn]] void throwUnwritable(const std::string& path, int error, const std::string& target);

// The path that writing to `path` writes to: symbolic links are followed, also where their target does not exist yet.
// Throws WorkError.
std::string linkTarget(const std::string& path);

// Gives an open file the permissions of the file that it will replace, if that is there. Best effort: some file systems
// have no permissions, which is no reason to fail.
void takePermissions(int descriptor, const std::string& target);

// Renames the complete file to linkTarget(path) so that the new name survives a power cut where the file system allows
// it. Throws WorkError, and leaves both files.
void replaceFile(const std::string& complete, const std::string& target, const std::string& path);

}  // namespace relief
