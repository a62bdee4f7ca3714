// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstring>

// OpenFOAM's libraries read $WM_PROJECT_DIR/etc while they are loaded, before main(). So that a bare `srun interphase`
// works, the program starts itself once more with the variable set where the environment lacks it.

namespace {

void set_project_dir_and_restart(int, char** argv, char** environment)
{
    constexpr std::size_t most_entries = 8192;
    constexpr char name[] = "WM_PROJECT_DIR=";
    static char entry[] = "WM_PROJECT_DIR=" INTERPHASE_FOAM_PROJECT_DIR;
    static char* extended[most_entries];
    std::size_t count = 0;
    for (char** variable = environment; *variable; ++variable) {
        if (std::strncmp(*variable, name, sizeof name - 1) == 0 || count + 2 >= most_entries) return;
        extended[count++] = *variable;
    }
    extended[count] = entry;
    execve("/proc/self/exe", argv, extended);  // on failure OpenFOAM says what it misses
}

}  // namespace

extern "C" {
__attribute__((section(".preinit_array"),
               used)) void (*interphase_foam_environment)(int, char**, char**) = set_project_dir_and_restart;
}
