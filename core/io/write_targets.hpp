// The rule for every file that is to be written: nothing that was read is replaced, and no file is written twice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "footfall/text.hpp"

namespace footfall::detail {

/// Whether two names lead to one file, through whatever links, folders and spellings; neither needs to exist yet. False
/// when one is empty.
bool sameFile(const std::string& a, const std::string& b);

/// The files that an environment's file names and that exist: material libraries and their textures (OBJ), buffers and
/// images (glTF), textures (other formats, by their usual endings); of a folder all meshes in it and what they name.
/// Reads the files; empty when they cannot be read.
std::vector<std::string> companionFiles(const std::string& environment);

/// One command, or one window: what it reads and what it is going to write.
class WriteTargets {
 public:
  /// `what` is said in messages: FOOTFALL_TEXT("the environment").
  void protect(const std::string& path, const Text& what);
  /// The environment with what its file names. That is only read once a target exists that could be one of it.
  void protectEnvironment(const std::string& path);
  /// The same where companionFiles() are known already.
  void protectEnvironment(const std::string& path, const std::vector<std::string>& companions);

  /// Throws InputError when `target` is one of the protected files, whatever name leads to it, or would be a mesh in an
  /// environment that is a folder. An empty name is none.
  void check(const std::string& target) const;
  /// check() and checkWritable(), and throws InputError too when an earlier target of add() is the same file. `what` is
  /// what will be in it.
  void add(const std::string& target, const Text& what);

 private:
  struct NamedFile {
    std::string path;
    Text what;
  };
  std::vector<NamedFile> protected_, targets_;
  std::vector<std::string> unread_;  ///< environments whose companions are not known
};

/// Refuses names of files that hold or belong to an environment of another format, so that a slip of the hand cannot
/// replace one. `option` is what is written, for the message; `allowed` is the ending with its dot, and no ending is
/// fine as well. Throws InputError.
void checkEnding(const std::string& target, const std::string& option, const std::string& allowed);

}  // namespace footfall::detail
