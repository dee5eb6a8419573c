// The rule for every file that is written: no input file is replaced, and no file is written twice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "footfall/text.hpp"

namespace footfall::detail {

/// Returns whether two names lead to one file, through any links, folders and spellings; neither needs to exist yet.
/// False when one is empty.
bool sameFile(const std::string& a, const std::string& b);

/// The existing files that an environment's file names: material libraries and their textures (OBJ), buffers and images
/// (glTF), textures (other formats, by their usual endings). A folder's companions are all meshes in it and the files
/// that they name. Reads the files; empty when they cannot be read.
std::vector<std::string> companionFiles(const std::string& environment);

/// The input and output files of one command or one window.
class WriteTargets {
 public:
  /// `what` names the file in messages: FOOTFALL_TEXT("the environment").
  void protect(const std::string& path, const Text& what);
  /// Protects the environment and the files that it names. These names are read only once a target exists that could be
  /// one of the files.
  void protectEnvironment(const std::string& path);
  /// Protects an environment whose companionFiles() are known already.
  void protectEnvironment(const std::string& path, const std::vector<std::string>& companions);

  /// Throws InputError when `target` is one of the protected files, by whatever name, or would be a mesh in an
  /// environment that is a folder. An empty name is not checked.
  void check(const std::string& target) const;
  /// Calls check() and checkWritable(), and also throws InputError when an earlier target of add() is the same file.
  /// `what` names the content of the file in messages.
  void add(const std::string& target, const Text& what);

 private:
  struct NamedFile {
    std::string path;
    Text what;
  };
  std::vector<NamedFile> protected_, targets_;
  std::vector<std::string> unread_;  ///< environments whose companions are not known
};

/// Throws InputError for names of files that hold or belong to an environment of another format, so that a slip of the
/// hand cannot replace one. `option` names the written file in the message; `allowed` is the ending with its dot. A
/// name without an ending is accepted as well.
void checkEnding(const std::string& target, const std::string& option, const std::string& allowed);

}  // namespace footfall::detail
