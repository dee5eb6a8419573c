// The command line program: `footfall run`, `why`, `cells`, `compare`, `info`, `pack` and so on. Needs no display.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdio>
#include <exception>

#include "app/command_line.hpp"
#include "core/base/exhaustion.hpp"
#include "footfall/errors.hpp"

namespace {

enum ExitCode { kDone = 0, kRunFailed = 1, kWrongInput = 2 };

int fail(ExitCode code, const char* message) {
  std::fprintf(stderr, "footfall: %s\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a write then fails with EPIPE when the reader has gone
  try {
    footfall::app::runCommandLine(argc, argv);
    return kDone;
  } catch (const footfall::InputError& error) {
    return fail(kWrongInput, error.what());
  } catch (const footfall::RunError& error) {
    return fail(kRunFailed, error.what());
  } catch (const footfall::Cancelled&) {
    return fail(kRunFailed, "cancelled");
  } catch (const std::exception& error) {
    if (const auto ranOut = footfall::detail::exhaustionText(error)) return fail(kRunFailed, ranOut->str().c_str());
    std::fprintf(stderr, "footfall: internal error (%s); please report it with what you typed\n", error.what());
    return kRunFailed;
  }
}
