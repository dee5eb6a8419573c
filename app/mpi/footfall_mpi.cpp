// `footfall-mpi run` and `cells`, started by mpirun or Slurm. The only program that needs MPI.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>

#include "app/command_list.hpp"
#include "app/command_options.hpp"
#include "app/mpi/mpi_program.hpp"
#include "core/base/exhaustion.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace {

using namespace footfall;

enum ExitCode { kDone = 0, kRunFailed = 1, kWrongInput = 2 };

// MPI and the library have threads that do not handle signals; one thread of this program waits for them.
void blockSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

// Adds the command that the editor starts.
void addCellsCommand(CLI::App& app, app::MpiProgram& program) {
  struct Options {
    std::string job;
    int threads = 0;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("cells", "Run the cells of a job that the editor left in a folder");
  command.add_option("JOB", options->job, "The folder of the job. The results stay there for the editor")->required();
  app::addThreads(command, options->threads);
  command.callback([options, &program] { program.runCells(options->job, options->threads); });
}

void runCommandLine(int argc, const char* const* argv, app::MpiProgram& program) {
  CLI::App app("Computes the exact walkable area of 3D environments, with several processes.", "footfall-mpi");
  app.set_version_flag("--version", "footfall-mpi " FOOTFALL_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  app::addRunCommand(app, program);
  addCellsCommand(app, program);
  try {
    app.parse(argc, argv);  // and runs the command
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
      throw InputError(std::string(error.what()) + "; `footfall-mpi --help` lists the commands and options");
    if (app::MpiProgram::isFirstByName()) app.exit(error);  // --help and --version
    app::print({});
  }
}

}  // namespace

int main(int argc, char** argv) {
  blockSignals();
  app::MpiProgram program;
  int code = kDone;
  const auto failAs = [&](ExitCode exitCode, detail::RankFailure kind, const std::string& problem) {
    if (program.fail(problem, kind)) std::fprintf(stderr, "footfall-mpi: %s\n", problem.c_str());
    // mpirun ends with the code of whoever is first to have one.
    code = program.hasExitCode() ? exitCode : kDone;
  };
  const auto fail = [&](ExitCode exitCode, const std::string& problem) {
    failAs(exitCode, exitCode == kWrongInput ? detail::RankFailure::Input : detail::RankFailure::Run, problem);
  };
  try {
    runCommandLine(argc, argv, program);
  } catch (const InputError& error) {
    fail(kWrongInput, error.what());
  } catch (const RunError& error) {
    fail(kRunFailed, error.what());
  } catch (const Cancelled&) {
    failAs(program.failedByInput() ? kWrongInput : kRunFailed, detail::RankFailure::Cancelled,
           program.failure().value_or("cancelled"));
  } catch (const std::bad_alloc&) {
    fail(kRunFailed, "memory ran out; close other programs, use more machines or a smaller environment");
  } catch (const std::exception& error) {
    const auto ranOut = detail::exhaustionText(error);
    fail(kRunFailed, ranOut
                         ? ranOut->str()
                         : "internal error (" + std::string(error.what()) + "); please report it with what you typed");
  }
  program.leave(code);
  return code;
}
