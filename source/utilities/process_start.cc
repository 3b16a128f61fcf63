// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/lac/full_matrix.h>

#include <lahar/utilities/failure.h>
#include <lahar/utilities/process_start.h>

#include <dlfcn.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace Lahar
{
  namespace
  {
    constexpr std::size_t MiB = 1024 * 1024;

    /// What MPI, BLAS on one thread and a mesh of a few hundred particles take beside the libraries' files, and what each
    /// further thread of BLAS takes.
    constexpr std::size_t needed_at_start = 448 * MiB, needed_by_thread = 144 * MiB;

    /// How many threads OpenBLAS will start; this is called before it has started.
    unsigned int n_blas_threads(char **environment)
    {
      using Parallel         = int (*)();
      const auto is_parallel = reinterpret_cast<Parallel>(dlsym(RTLD_DEFAULT, "openblas_get_parallel"));
      cpu_set_t processors;
      if (is_parallel == nullptr || is_parallel() == 0 ||
          sched_getaffinity(0, sizeof(processors), &processors) != 0)
        return 1;
      const unsigned int n_processors = CPU_COUNT(&processors);
      // In this order.
      for (const char *name : {"OPENBLAS_NUM_THREADS=", "GOTO_NUM_THREADS=", "OMP_NUM_THREADS="})
        for (char **entry = environment; *entry != nullptr; ++entry)
          if (std::strncmp(*entry, name, std::strlen(name)) == 0)
            if (const int n = std::atoi(*entry + std::strlen(name)); n > 0)
              return std::min<unsigned int>(n, n_processors);
      return n_processors;
    }

    /// Without the streams of the C++ library, which may not have started, or may be in the middle of something.
    void say(const char *text)
    {
      if (write(STDERR_FILENO, text, std::strlen(text)) < 0)
        return; // there is no other place
    }

    void open_standard_streams()
    {
      for (int descriptor = ::open("/dev/null", O_RDWR); descriptor >= 0;
           descriptor     = ::open("/dev/null", O_RDWR))
        if (descriptor > STDERR_FILENO)
        {
              ::close(descriptor);
              return;
        }
    }

    /// Size of the address space in use, bytes.
    std::size_t used_address_space()
    {
      unsigned long pages = 0;
      if (std::FILE *file = std::fopen("/proc/self/statm", "r"))
      {
        if (std::fscanf(file, "%lu", &pages) != 1)
          pages = 0;
        std::fclose(file);
      }
      return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    }
  } // namespace



  void prepare_process(int, char **, char **environment)
  {
    open_standard_streams();
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
      return;
    const unsigned int n_threads = n_blas_threads(environment);
    const std::size_t needed     = needed_at_start + (n_threads - 1) * needed_by_thread;
    const std::size_t used       = used_address_space();
    if (used + needed <= limit.rlim_cur)
      return;
    char text[400];
    std::snprintf(
      text, sizeof(text),
      "lahar: the run failed. The address space is limited to %lu kB (ulimit -v). Needed: %lu kB and what the case "
      "takes, since the libraries take %lu kB, MPI and %u thread%s of BLAS %lu kB.\n",
      static_cast<unsigned long>(limit.rlim_cur / 1024), static_cast<unsigned long>((used + needed) / 1024),
      static_cast<unsigned long>(used / 1024), n_threads, n_threads == 1 ? "" : "s",
      static_cast<unsigned long>(needed / 1024));
    say(text);
    _exit(1);
  }



  void reserve_blas_buffers()
  {
    // Large enough not to be computed without buffers.
    const dealii::FullMatrix<double> a(dealii::IdentityMatrix(128));
    dealii::FullMatrix<double> product(128, 128);
    a.mmult(product, a);
  }



  namespace
  {
    /// The stack may be what could not grow.
    char crash_stack[1 << 16];

    void handle_crash(const int number)
    {
      const auto tell = [](const char *reason) {
        say("lahar: the run failed. ");
        say(reason);
        say("\n");
        log_failure(reason);
      };
      rlimit limit;
      if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      {
        tell("There is not enough memory (ulimit -v), and a library has crashed for it.");
        _exit(1);
      }
      tell("The program has crashed; option --resume goes on from the last checkpoint.");
      std::signal(number, SIG_DFL);
      std::raise(number);
    }
  } // namespace



  void report_crashes()
  {
    stack_t stack{};
    stack.ss_sp   = crash_stack;
    stack.ss_size = sizeof(crash_stack);
    struct sigaction action
    {};
    action.sa_handler = handle_crash;
    action.sa_flags   = SA_ONSTACK | SA_NODEFER;
    if (sigaltstack(&stack, nullptr) == 0)
      for (const int number : {SIGSEGV, SIGBUS, SIGABRT}) // the last one: a heap that a library has spoilt
        sigaction(number, &action, nullptr);
  }



  std::string address_space_limit()
  {
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
      return "";
    return " (ulimit -v: " + std::to_string(limit.rlim_cur / 1024) + " kB)";
  }
} // namespace Lahar
