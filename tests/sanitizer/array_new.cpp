// SPDX-License-Identifier: GPL-3.0-or-later
// Linked to what runs OpenFOAM under the address sanitizer. Foam::sqr of vectors, as it is in Debian's package, takes
// two numbers at a time and so reads one behind the last; where such a list ends with the memory that the sanitizer
// has, that is a crash. OpenFOAM's lists come from new[], ours (std::vector) from new: the latter are watched to the
// last byte.
#include <cstdlib>
#include <new>

void* operator new[](std::size_t size)
{
    if (void* memory = std::malloc(size + sizeof(double))) return memory;
    throw std::bad_alloc();
}

void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
