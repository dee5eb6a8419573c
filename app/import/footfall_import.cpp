// footfall-import PARENT FILE: reads a file of a foreign format for the process PARENT, which started it, and writes
// what is in it to standard output (core/io/foreign_stream.hpp). Readers of others may die here without harm.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "core/io/foreign/foreign_formats.hpp"
#include "core/io/foreign_stream.hpp"
#include "footfall/errors.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;

constexpr int kCannotWrite = 3, kWrongUse = 2;
constexpr std::size_t kStackBytes = std::size_t{512} << 20;  // readers call themselves for each node within a node

struct Task {
  std::string path;
  int output = -1;
};

std::string streamOf(const std::string& path) {
  try {
    Environment environment;
    const FileFrame frame = readForeignFile(path, environment);
    return encodeEnvironment(environment, frame);
  } catch (const TextError& error) {
    return encodeError(error.text());
  } catch (const std::bad_alloc&) {
    return encodeError(Text(FOOTFALL_TEXT("%1: its reader asked for more memory than there is; check that the file is "
                                          "complete and in order, or close other programs"),
                            path));
  } catch (const std::exception& error) {
    return encodeError(Text(FOOTFALL_TEXT("%1: cannot be read (%2); check that the file is complete and of the format "
                                          "that its extension says"),
                            path, error.what())
                           .inOneLine());
  }
}

[[noreturn]] void work(const Task& task) {
  const std::string stream = streamOf(task.path);
  std::string_view rest = stream;
  while (!rest.empty()) {
    const ssize_t count = ::write(task.output, rest.data(), rest.size());
    if (count < 0 && errno != EINTR) ::_exit(kCannotWrite);
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  ::_exit(0);  // nothing is freed: that takes time
}

/// Makes this process end with its parent, write no core dump, and be killed first where memory runs out.
bool prepare(const char* parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != std::atoi(parent)) return false;
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  if (std::FILE* score = std::fopen("/proc/self/oom_score_adj", "w"); score != nullptr) {
    std::fputs("1000", score);
    std::fclose(score);
  }
  return true;
}

/// Readers print now and then; what they print must not get between.
int takeOutput() {
  const int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0) ::dup2(nothing, STDOUT_FILENO);
  return output;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("footfall-import is started by Footfall, to read files of other formats; use footfall info FILE\n",
               stderr);
    return kWrongUse;
  }
  if (!prepare(argv[1])) return kWrongUse;
  Task task{argv[2], takeOutput()};
  if (task.output < 0) return kCannotWrite;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackBytes);
  pthread_t thread{};
  const auto start = [](void* given) -> void* { work(*static_cast<const Task*>(given)); };
  if (pthread_create(&thread, &attributes, start, &task) != 0) work(task);
  pthread_join(thread, nullptr);
  return kCannotWrite;  // not reached
}
