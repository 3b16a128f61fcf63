// SPDX-License-Identifier: GPL-3.0-or-later

// The program `lahar` as a server that loads its libraries and starts MPI once for many cases.
//
// Its arguments are the largest number of cases that one process reads, and then those of `lahar`. For each line of the
// standard input,
//
//   SECONDS BYTES DIRECTORY
//
// a child process does in that directory what main() does with these arguments, with so much time and address space (0:
// as the server). What it prints goes to DIRECTORY.out and DIRECTORY.err; the answer is a line "exited STATUS", "killed
// SIGNAL" or "late". A child that ends otherwise than by wrong input or success reads no other case.

#define main lahar_program
#include "../../source/main.cc"
#undef main

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

namespace
{
  struct Request
  {
    double seconds;
    rlim_t bytes;
    std::string directory;
  };



  [[noreturn]] void fail(const std::string &what)
  {
    std::cerr << "check_server: " << what << ": " << std::strerror(errno) << std::endl;
    _exit(125);
  }



  void redirect(const int descriptor, const std::string &name, const int flags)
  {
    const int file = open(name.c_str(), flags | O_CLOEXEC, 0666);
    if (file < 0 || dup2(file, descriptor) < 0 || close(file) != 0)
      fail(name);
  }



  /// A process that reads cases whose directories come through a socket, and answers with their status.
  class Child
  {
  public:
    Child(const rlim_t bytes, const int argc, char **argv)
    {
      int ends[2];
      if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0 || (process = fork()) < 0)
        fail("fork");
      close(ends[process == 0 ? 0 : 1]);
      socket = ends[process == 0 ? 1 : 0];
      if (process == 0)
        read_cases(bytes, argc, argv);
    }

    ~Child()
    {
      close(socket); // the child reads that there is nothing more
      if (process > 0)
        waitpid(process, nullptr, 0);
    }

    Child(const Child &)            = delete;
    Child &operator=(const Child &) = delete;

    /// The answer to a request. @param goes_on is set to whether the child can read another case.
    std::string read(const Request &request, bool &goes_on)
    {
      if (send(socket, request.directory.data(), request.directory.size(), 0) < 0)
        fail("send");
      pollfd answer{socket, POLLIN, 0};
      const bool late = poll(&answer, 1, static_cast<int>(1000. * request.seconds)) == 0;
      int status      = 0;
      goes_on         = !late && recv(socket, &status, sizeof(status), 0) == sizeof(status);
      if (goes_on)
      {
        goes_on = status == 0 || status == 2;
        return "exited " + std::to_string(status);
      }
      if (late)
        kill(process, SIGKILL);
      if (waitpid(process, &status, 0) != process)
        fail("waitpid");
      process = -1;
      return late                  ? "late"
             : WIFSIGNALED(status) ? "killed " + std::to_string(WTERMSIG(status))
                                   : "exited " + std::to_string(WEXITSTATUS(status));
    }

  private:
    [[noreturn]] void read_cases(const rlim_t bytes, const int argc, char **argv) const
    {
      const rlimit no_core{0, 0}, space{bytes, bytes};
      if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || setrlimit(RLIMIT_CORE, &no_core) != 0 ||
          (bytes > 0 && setrlimit(RLIMIT_AS, &space) != 0))
        fail("setrlimit");
      redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
      char name[4096];
      for (ssize_t n; (n = recv(socket, name, sizeof(name), 0)) > 0;)
      {
        const std::string directory(name, n);
        redirect(STDOUT_FILENO, directory + ".out", O_WRONLY | O_CREAT | O_TRUNC);
        redirect(STDERR_FILENO, directory + ".err", O_WRONLY | O_CREAT | O_TRUNC);
        if (chdir(directory.c_str()) != 0)
          fail(directory);
        int status         = 0;
        const int failures = exit_status(MPI_COMM_WORLD, [&] { status = lahar_main(argc, argv); });
        status             = std::max(status, failures);
        std::cout << std::flush;
        if (send(socket, &status, sizeof(status), 0) != sizeof(status))
          break;
      }
      _exit(0); // without destructors of libraries, which may wait for threads of the server's
    }

    pid_t process = -1;
    int socket    = -1;
  };



  void serve(const unsigned int n_cases, const int argc, char **argv)
  {
    std::cout << "ready" << std::endl;
    std::unique_ptr<Child> child;
    unsigned int n_read = 0;
    for (Request request; std::cin >> request.seconds >> request.bytes >> std::ws &&
                          std::getline(std::cin, request.directory);)
    {
      if (child == nullptr)
      {
        child  = std::make_unique<Child>(request.bytes, argc, argv);
        n_read = 0;
      }
      bool goes_on = false;
      std::cout << child->read(request, goes_on) << std::endl;
      if (!goes_on || ++n_read >= n_cases)
        child.reset();
    }
  }
} // namespace



int main(int argc, char **argv)
{
  if (argc < 3)
  {
    std::cerr << "Usage: check_server NUMBER [option of lahar]... case.prm" << std::endl;
    return 2;
  }
  // As in the program's own main().
  reserve_blas_buffers();
  reserve_memory_for_failure();
  int n_words   = 1;
  char *words[] = {argv[0], nullptr}, **name = words;
  Utilities::MPI::MPI_InitFinalize mpi(n_words, name, 1);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
#ifndef LAHAR_SANITIZE
  report_crashes();
#endif
  const unsigned int n_cases = std::stoul(argv[1]);
  argv[1]                    = argv[0];
  serve(n_cases, argc - 1, argv + 1);
  return 0;
}
