// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Counts what the current thread allocates with `new`: include it in the one source file of a test
// that has to show that a path allocates nothing.

#include <cstddef>
#include <cstdlib>
#include <new>

namespace placode::test {
inline thread_local long allocations = 0;
}

// The compiler sees through the pair below and takes malloc and free for strangers.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) {
    ++placode::test::allocations;
    if (void* place = std::malloc(size)) return place;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t align) {
    ++placode::test::allocations;
    const auto edge = static_cast<std::size_t>(align);
    if (void* place = std::aligned_alloc(edge, (size + edge - 1) / edge * edge)) return place;
    throw std::bad_alloc();
}
void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
